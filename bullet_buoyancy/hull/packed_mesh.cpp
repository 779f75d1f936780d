#include "bullet_buoyancy/hull/packed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace bullet_buoyancy {

namespace {

/// So many packs or clusters are looked at one by one as fast as in a cluster.
constexpr std::size_t few = 4;

/// Half the size of a box that no plane cuts, m.
constexpr double nothing = -1e18;

using Corners = std::array<Vec3, 3>;
using CornerList = std::vector<Corners>;

Vec3 centreOf(const Corners& t) {
    return (t[0] + t[1] + t[2]) / 3;
}

/// Halves until a pack is left, along the longest side of the centres' box; the first half is the largest
/// power of two of packs, so that any sixteen in a row which begin at a multiple of sixteen are neighbours.
void sortIntoPacks(CornerList::iterator begin, CornerList::iterator end) {
    const auto packs = (end - begin + packSize - 1) / packSize;
    if (packs <= 1) return;
    std::ptrdiff_t half = 1;
    while (2 * half < packs)
        half *= 2;
    Eigen::AlignedBox3d box;
    std::for_each(begin, end, [&](const Corners& t) { box.extend(centreOf(t)); });
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto middle = begin + half * packSize;
    std::nth_element(begin, middle, end, [&](const Corners& left, const Corners& right) {
        return centreOf(left)[axis] < centreOf(right)[axis];
    });
    sortIntoPacks(begin, middle);
    sortIntoPacks(middle, end);
}

/// What a child of a cluster is made of.
struct Piece {
    Eigen::AlignedBox3d box;
    Vec3 normal = Vec3::Zero();
    Mat3 first = Mat3::Zero();
    std::array<Mat3, 3> second{Mat3::Zero(), Mat3::Zero(), Mat3::Zero()};  // second[k](i, j): of x_i x_j n_k
    Vec3 unsignedNormal = Vec3::Zero();
    double area = 0;

    void add(const Corners& t) {
        const Vec3 areaVector = (t[1] - t[0]).cross(t[2] - t[0]) / 2, sum = t[0] + t[1] + t[2];
        Mat3 square = sum * sum.transpose();
        for (const Vec3& corner : t) {
            square += corner * corner.transpose();
            box.extend(corner);
        }
        normal += areaVector;
        first += sum / 3 * areaVector.transpose();
        for (Eigen::Index k = 0; k < 3; ++k)
            second[std::size_t(k)] += areaVector[k] / 12 * square;
        unsignedNormal += areaVector.cwiseAbs();
        area += areaVector.norm();
    }

    void add(const Piece& other) {
        box.extend(other.box);
        normal += other.normal;
        first += other.first;
        for (std::size_t k = 0; k < 3; ++k)
            second[k] += other.second[k];
        unsignedNormal += other.unsignedNormal;
        area += other.area;
    }
};

template <typename Real>
void write(const Piece& piece, int lane, Cluster<Real>& cluster) {
    const Vec3 centre = piece.box.center();
    // Rounding must not make the box smaller.
    const Vec3 halfExtents =
        (1 + 4 * double(std::numeric_limits<Real>::epsilon())) * (piece.box.sizes() / 2 + centre.cwiseAbs()) -
        centre.cwiseAbs();
    MomentRows<Real>& moments = cluster.moments;
    moments.area.lane[lane] = Real(piece.area);
    for (int i = 0; i < 3; ++i) {
        cluster.centre[i].lane[lane] = Real(centre[i]);
        cluster.halfExtents[i].lane[lane] = Real(halfExtents[i]);
        moments.normal[i].lane[lane] = Real(piece.normal[i]);
        moments.unsignedNormal[i].lane[lane] = Real(piece.unsignedNormal[i]);
        for (int j = 0; j < 3; ++j)
            moments.first[i][j].lane[lane] = Real(piece.first(i, j));
    }
    int row = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++row)
            for (int k = 0; k < 3; ++k)
                moments.second[row][k].lane[lane] = Real(piece.second[std::size_t(k)](i, j));
}

template <typename Real>
Cluster<Real> emptyCluster() {
    Cluster<Real> cluster{};
    for (PackRow<Real>& row : cluster.halfExtents)
        std::fill(std::begin(row.lane), std::end(row.lane), Real(nothing));
    return cluster;
}

/// Clusters of those pieces, and the pieces that they are in turn.
template <typename Real>
std::vector<Cluster<Real>> gather(std::vector<Piece>& pieces) {
    const std::size_t count = (pieces.size() + packSize - 1) / packSize;
    std::vector<Cluster<Real>> clusters(count, emptyCluster<Real>());
    std::vector<Piece> whole(count);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        write(pieces[i], int(i % packSize), clusters[i / packSize]);
        whole[i / packSize].add(pieces[i]);
    }
    pieces = std::move(whole);
    return clusters;
}

template <typename Real>
Corners rounded(const Corners& t) {
    return {t[0].cast<Real>().template cast<double>(), t[1].cast<Real>().template cast<double>(),
            t[2].cast<Real>().template cast<double>()};
}

template <typename Real>
PackedTriangles<Real> pack(const CornerList& sorted) {
    PackedTriangles<Real> packed;
    packed.packs.resize((sorted.size() + packSize - 1) / packSize);
    std::vector<Piece> pieces(packed.packs.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const Corners t = rounded<Real>(sorted[i]);
        const Vec3 areaVector = (t[1] - t[0]).cross(t[2] - t[0]) / 2;
        TrianglePack<Real>& into = packed.packs[i / packSize];
        const std::size_t lane = i % packSize;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            into.a[axis].lane[lane] = Real(t[0][axis]);
            into.b[axis].lane[lane] = Real(t[1][axis]);
            into.c[axis].lane[lane] = Real(t[2][axis]);
            into.areaVector[axis].lane[lane] = Real(areaVector[axis]);
        }
        into.area.lane[lane] = Real(areaVector.norm());
        pieces[i / packSize].add(t);
    }
    while (pieces.size() > few)
        packed.levels.push_back(gather<Real>(pieces));
    return packed;
}

}  // namespace

PackedMesh packMesh(const TriangleMesh& mesh, const Vec3& origin) {
    CornerList sorted;
    sorted.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        sorted.push_back(
            {mesh.vertices[t[0]] - origin, mesh.vertices[t[1]] - origin, mesh.vertices[t[2]] - origin});
    sortIntoPacks(sorted.begin(), sorted.end());
    double reach = 0, area = 0;
    for (const Corners& t : sorted) {
        area += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
        for (const Vec3& corner : t)
            reach = std::max(reach, corner.norm());
    }
    const double errorOfSingle = 4 * double(std::numeric_limits<float>::epsilon()) * area * reach;
    return {origin, errorOfSingle, pack<float>(sorted), pack<double>(sorted)};
}

}  // namespace bullet_buoyancy
