#include "bullet_buoyancy/hull/hull_status.h"

#include <sstream>

namespace bullet_buoyancy {

namespace {

const char* explain(const HullStatus& status) {
    switch (status.error) {
        case HullError::none:
            return "ok";
        case HullError::unsupportedShape:
            return status.reason;
        case HullError::noTriangles:
            return "there is nothing to wet: no triangles and no solids";
        case HullError::badIndices:
            return "a triangle names a vertex that does not exist";
        case HullError::notFinite:
            return "a coordinate, the volume or its centre is not finite";
        case HullError::flatPoints:
            return "the points of a convex hull lie in one plane";
        case HullError::noVolume:
            return "the surface encloses no volume";
    }
    return "unknown error";
}

}  // namespace

std::string HullStatus::describe() const {
    if (!accepted()) return explain(*this);
    std::ostringstream text;
    const auto remark = [&](auto value, const char* what) {
        if (value > 0) text << (text.tellp() > 0 ? "; " : "") << value << what;
    };
    remark(weldedVertices, " repeated or unused vertices taken out");
    remark(degenerateTriangles, " triangles without area taken out");
    remark(duplicateTriangles, " repeated triangles taken out");
    remark(flippedTriangles, " triangles turned outward");
    remark(openEdges, " open edges: pressure acts on the triangles that are there");
    remark(overlappingPairs, " pairs of parts overlap and displace the water there twice");
    remark(overlapVolume, " m^3 (estimated) displaced twice");
    remark(uncheckedPairs, " pairs of solids in one mesh not checked for overlap");
    remark(tessellationError, " of the volume uncertain by tessellation");
    return text.tellp() > 0 ? text.str() : explain(*this);
}

}  // namespace bullet_buoyancy
