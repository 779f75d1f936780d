#include "bullet_buoyancy/hydrostatics/mesh_in_waves.h"

#include <array>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/pack_rows.h"
#include "bullet_buoyancy/hydrostatics/wet_triangle.h"

namespace bullet_buoyancy {

namespace {

using Corners = std::array<HeadPoint, 3>;

Vec3 areaVectorOf(const Corners& p) {
    return (p[1].position - p[0].position).cross(p[2].position - p[0].position) / 2;
}

double wetShareBelow(const Corners& p, double level) {
    return wetShare(p[0].depth + level, p[1].depth + level, p[2].depth + level);
}

/// Mean error of the head over a triangle by misplacing its waterline, where depths are off by up to
/// `strayed`: within the band in which they may have the other sign, up to that.
double waterlineError(const Corners& p, double strayed) {
    return strayed * (wetShareBelow(p, strayed) - wetShareBelow(p, -strayed));
}

/// Second differences of a quadratic along the sides of a triangle, each that opposite to its corner. Between
/// the corners it strays from the linear by -1/2 sum l_i l_j b_ij in barycentric coordinates l: by a sixth of
/// the largest at most, by a 24th of their sum on average.
struct Bubble {
    std::array<double, 3> across;

    Bubble(const Corners& p, const Mat3& bend) {
        const Vec3 u = p[1].position - p[0].position, v = p[2].position - p[1].position, w = -u - v;
        across = {v.dot(bend * v), w.dot(bend * w), u.dot(bend * u)};
    }

    double largest() const {
        return std::max({std::abs(across[0]), std::abs(across[1]), std::abs(across[2])}) / 6;
    }
    double mean() const { return (std::abs(across[0]) + std::abs(across[1]) + std::abs(across[2])) / 24; }
};

/// What a quadratic adds to the linear function that was taken for it, at the corners of a triangle and in
/// the middle of the sides opposite to them.
struct Excess {
    std::array<double, 3> at, across;

    /// Where the linear function was taken from the triangle's own corners.
    explicit Excess(const Bubble& bubble)
        : at{0, 0, 0}, across{-bubble.across[0] / 8, -bubble.across[1] / 8, -bubble.across[2] / 8} {}

    /// Where the triangle is a part of that one. `linear`: the linear function's values.
    Excess(const Corners& p, double HeadPoint::*linear, const Quadratic& quadratic, const Vec3& centre) {
        for (std::size_t i = 0; i < 3; ++i) {
            const HeadPoint &q = p[(i + 1) % 3], &r = p[(i + 2) % 3];
            at[i] = quadratic.at(p[i].position - centre) - p[i].*linear;
            across[i] = quadratic.at((q.position + r.position) / 2 - centre) - (q.*linear + r.*linear) / 2;
        }
    }

    double mean() const { return (across[0] + across[1] + across[2]) / 3; }

    /// Mean of f r over the triangle: by the mass matrix of quadratic with linear shape functions.
    Vec3 meanMoment(const Corners& p) const {
        Vec3 moment = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            const double weight =
                at[i] / 30 - (at[j] + at[k]) / 60 + across[i] / 15 + 2 * (across[j] + across[k]) / 15;
            moment += weight * p[i].position;
        }
        return moment;
    }
};

/// What the water's bend adds to a wet triangle over which depth and head were taken for linear.
void addBend(const Corners& p, const Excess& depth, const Excess& head, const Vec3& up,
             WetIntegrals& integrals) {
    const Vec3 areaVector = areaVectorOf(p);
    const double areaUp = areaVector.dot(up);
    double depthSquared = 0, depthTimesHead = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const HeadPoint &q = p[(i + 1) % 3], &r = p[(i + 2) % 3];
        const double d = (q.depth + r.depth) / 2, h = (q.head + r.head) / 2;
        depthSquared += depth.across[i] * (2 * d + depth.across[i]) / 3;
        depthTimesHead += (depth.across[i] * (h + head.across[i]) + d * head.across[i]) / 3;
    }
    const Vec3 headMoment = head.meanMoment(p);
    const Vec3 depthMoment = &depth == &head ? headMoment : depth.meanMoment(p);
    integrals.headNormal += head.mean() * areaVector;
    integrals.headTorque += headMoment.cross(areaVector);
    integrals.volume -= depth.mean() * areaUp;
    integrals.volumeMoment -= areaUp * (depthMoment + depthSquared / 2 * up);
    integrals.headVolume -= depthTimesHead / 2 * areaUp;
}

/// A point of the mesh as an expansion sees it.
struct SeenPoint {
    HeadPoint point;
    double distance2;  // from the expansion's centre, as distances count, m^2
};

class TrianglesInWaves {
public:
    TrianglesInWaves(const WaterPatch& water, double headError, const HydrostaticQuery& query,
                     WetIntegrals& integrals)
        : m_water(water), m_headError(headError), m_query(query), m_integrals(integrals) {}

    /// The whole mesh; each vertex is looked at once if there is one cell only, and room for them.
    void add(const TriangleMesh& mesh) {
        constexpr std::size_t room = 512;
        const std::vector<Vec3>& vertices = mesh.vertices;
        if (m_water.cellCount() > 1 || vertices.size() > room) {
            for (const Triangle& t : mesh.triangles)
                add(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
            return;
        }
        std::array<SeenPoint, room> seen;
        const WaterExpansion& water = m_water.near(vertices[0]);
        for (std::size_t i = 0; i < vertices.size(); ++i)
            seen[i] = see(water, vertices[i]);
        for (const Triangle& t : mesh.triangles)
            add(water, {seen[t[0]], seen[t[1]], seen[t[2]]}, 0);
    }

    void add(const TrianglePack<double>& pack, const std::uint8_t* which, int count, const Vec3& origin) {
        for (int i = 0; i < count; ++i)
            add(origin + vectorOf(pack.a, which[i]), origin + vectorOf(pack.b, which[i]),
                origin + vectorOf(pack.c, which[i]));
    }

private:
    void add(const Vec3& a, const Vec3& b, const Vec3& c, int quarterings = 0) {
        const WaterExpansion& water = m_water.near((a + b + c) / 3);
        add(water, {see(water, a), see(water, b), see(water, c)}, quarterings);
    }

    SeenPoint see(const WaterExpansion& water, const Vec3& point) const {
        const double depth = water.depthAt(point);
        return {{point, depth, isHydrostatic() ? depth : water.headAt(point)},
                m_water.distanceSquared(water, point)};
    }

    void add(const WaterExpansion& water, const std::array<SeenPoint, 3>& seen, int quarterings) {
        const Corners p{seen[0].point, seen[1].point, seen[2].point};
        const double farthest2 = std::max({seen[0].distance2, seen[1].distance2, seen[2].distance2});
        const ExpansionError& error = m_water.errorOf(water, farthest2);
        const double largestError = error.at(farthest2);
        const Bubble bubble(p, water.head.bend);
        double bend = bubble.largest();
        if (!isHydrostatic()) bend = std::max(bend, Bubble(p, water.depth.bend).largest());
        const double strayed = largestError + bend;
        const double least = std::min({p[0].depth, p[1].depth, p[2].depth});
        if (std::max({p[0].depth, p[1].depth, p[2].depth}) <= -strayed) return;

        const double atWaterline = least < strayed ? waterlineError(p, strayed) : 0;
        const bool reachesOver = largestError > m_headError && isLargerThanACell(p);
        const bool missesWaterline = atWaterline > m_headError / 4 && bend > largestError;
        constexpr int mostQuarterings = 6;
        if ((reachesOver || missesWaterline) && quarterings < mostQuarterings)
            return addQuarters(p, quarterings + 1);

        constexpr double negligible = 1.0 / 16;  // of the error allowed
        const bool isBent = bubble.mean() > negligible * m_headError;
        if (isBent)
            addBent(p, water, bubble);
        else
            visitWetPart(p[0], p[1], p[2], [&](const HeadPoint& q, const HeadPoint& r, const HeadPoint& s) {
                addWetTriangle(q, r, s, m_water.upInBody(), m_query, m_integrals);
            });
        // The error is convex: over the triangle its mean is at most that of the corners.
        const double ofCorners =
            (error.at(seen[0].distance2) + error.at(seen[1].distance2) + error.at(seen[2].distance2)) / 3;
        const double share = least < -strayed ? wetShareBelow(p, strayed) : 1;
        const double leftOut = isBent ? 0 : std::min(bubble.mean(), share * bend);
        const Vec3 area = areaVectorOf(p).cwiseAbs();
        m_integrals.error += (std::min(ofCorners, share * largestError) + leftOut) * area;
        (bend > largestError ? m_integrals.lastingError : m_integrals.error) += atWaterline * area;
    }

    void addBent(const Corners& p, const WaterExpansion& water, const Bubble& bubble) {
        const Vec3& up = m_water.upInBody();
        if (isHydrostatic() && std::min({p[0].depth, p[1].depth, p[2].depth}) > 0) {
            const Excess excess(bubble);
            addWetTriangle(p[0], p[1], p[2], up, m_query, m_integrals);
            return addBend(p, excess, excess, up, m_integrals);
        }
        visitWetPart(p[0], p[1], p[2], [&](const HeadPoint& q, const HeadPoint& r, const HeadPoint& s) {
            addWetTriangle(q, r, s, up, m_query, m_integrals);
            const Corners part{q, r, s};
            const Excess head(part, &HeadPoint::head, water.head, water.centre);
            if (isHydrostatic()) return addBend(part, head, head, up, m_integrals);
            const Excess depth(part, &HeadPoint::depth, water.depth, water.centre);
            addBend(part, depth, head, up, m_integrals);
        });
    }

    bool isHydrostatic() const { return m_water.pressure() == PressureModel::hydrostatic; }

    bool isLargerThanACell(const Corners& p) const {
        if (m_water.cellCount() == 1) return false;
        constexpr double rounding = 1e-9;
        const Vec3 &a = p[0].position, &b = p[1].position, &c = p[2].position;
        const Vec3 size = a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
        return (size - (1 + rounding) * m_water.cell()).maxCoeff() > 0;
    }

    void addQuarters(const Corners& p, int quarterings) {
        const Vec3 &a = p[0].position, &b = p[1].position, &c = p[2].position;
        const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
        add(a, ab, ca, quarterings);
        add(ab, b, bc, quarterings);
        add(ca, bc, c, quarterings);
        add(ab, bc, ca, quarterings);
    }

    const WaterPatch& m_water;
    double m_headError;
    const HydrostaticQuery& m_query;
    WetIntegrals& m_integrals;
};

constexpr int trianglesAtOnce = 32;
using CornerPoints = Eigen::Array<double, Eigen::Dynamic, 3, Eigen::ColMajor, 3 * trianglesAtOnce, 3>;
using CornerHeads = Eigen::Array<double, Eigen::Dynamic, 10, Eigen::ColMajor, 3 * trianglesAtOnce, 10>;

/// Depth and head at points of the water's frame.
struct CornerSamples {
    Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 * trianglesAtOnce, 1> depth, head;

    CornerSamples(const WaterView& water, const CornerPoints& points) {
        CornerPoints surface(points.rows(), 3);
        water.field.sampleSurface(points.leftCols<2>(), water.time, surface);
        depth = surface.col(0) - points.col(2);
        head = depth;
        if (water.pressure == PressureModel::hydrostatic) return;
        CornerPoints below = points;
        below.col(2) = -depth;
        CornerHeads heads(points.rows(), 10);
        water.field.expandWaveHead(below, water.time, heads);
        head = heads.col(0) - points.col(2);
    }
};

/// Within a triangle whose longest side is L a surface of that bend strays from its corners' plane by no more
/// than half of it times the square of the radius of the circle that encloses the triangle, L / sqrt(3).
double strayedWithin(const Corners& p, double bend) {
    const double side2 = std::max({(p[1].position - p[0].position).squaredNorm(),
                                   (p[2].position - p[1].position).squaredNorm(),
                                   (p[0].position - p[2].position).squaredNorm()});
    return bend * side2 / 6;
}

}  // namespace

void addMeshInWaves(const TriangleMesh& mesh, const WaterPatch& water, double headError,
                    const HydrostaticQuery& query, WetIntegrals& integrals) {
    if (!mesh.triangles.empty()) TrianglesInWaves(water, headError, query, integrals).add(mesh);
}

void addInWaves(const TrianglePack<double>& pack, const std::uint8_t* which, int count, const Vec3& origin,
                const WaterPatch& water, double headError, const HydrostaticQuery& query,
                WetIntegrals& integrals) {
    TrianglesInWaves(water, headError, query, integrals).add(pack, which, count, origin);
}

int addMeshByCorners(const TriangleMesh& mesh, const WaterView& water, const HydrostaticQuery& query,
                     WetIntegrals& integrals) {
    const Vec3 up = water.upInBody(), origin = water.field.frame().pointFromWorld(water.pose.position);
    const Mat3 frameFromBody = water.field.frame().worldFromFrame().transpose() * water.pose.worldFromBody();
    const double bend = headBend(water);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t first = 0; first < count; first += trianglesAtOnce) {
        const std::size_t here = std::min<std::size_t>(trianglesAtOnce, count - first);
        CornerPoints points(Eigen::Index(3 * here), 3);
        for (std::size_t i = 0; i < 3 * here; ++i) {
            const Vec3& vertex = mesh.vertices[mesh.triangles[first + i / 3][i % 3]];
            points.row(Eigen::Index(i)) = (origin + frameFromBody * vertex).transpose().array();
        }
        const CornerSamples samples(water, points);
        for (std::size_t i = 0; i < here; ++i) {
            Corners p;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto row = Eigen::Index(3 * i + k);
                p[k] = {mesh.vertices[mesh.triangles[first + i][k]], samples.depth[row], samples.head[row]};
            }
            visitWetPart(p[0], p[1], p[2], [&](const HeadPoint& q, const HeadPoint& r, const HeadPoint& s) {
                addWetTriangle(q, r, s, up, query, integrals);
            });
            const double strayed = strayedWithin(p, bend);
            const Vec3 area = areaVectorOf(p).cwiseAbs();
            integrals.error += strayed * wetShareBelow(p, strayed) * area;
            integrals.lastingError += waterlineError(p, strayed) * area;
        }
    }
    return int(3 * count);
}

}  // namespace bullet_buoyancy
