#include "bullet_buoyancy/hull/place_part.h"

#include <cmath>

namespace bullet_buoyancy {

namespace {

struct Place {
    const Pose& pose;
    double scale;

    Vec3 point(const Vec3& p) const { return pose.position + pose.orientation * (scale * p); }

    HullPart operator()(TriangleMesh mesh) const {
        for (Vec3& vertex : mesh.vertices)
            vertex = point(vertex);
        return mesh;
    }

    HullPart operator()(const Sphere& sphere) const {
        return Sphere{point(sphere.centre), std::abs(scale) * sphere.radius};
    }

    HullPart operator()(SolidOfRevolution solid) const {
        solid.origin = point(solid.origin);
        solid.axis = pose.orientation * (scale < 0 ? Vec3(-solid.axis) : solid.axis);
        const double size = std::abs(scale);
        for (ProfilePiece& piece : solid.profile)
            piece = {size * piece.begin, size * piece.end, size * size * piece.c0, size * piece.c1, piece.c2};
        return solid;
    }
};

}  // namespace

HullPart placed(const HullPart& part, const Pose& pose, double scale) {
    return std::visit(Place{pose, scale}, part);
}

}  // namespace bullet_buoyancy
