#pragma once

#include <string>
#include <vector>

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// A cube of 1 m (or two of them), as someone modelled it.
struct FaultyMesh {
    std::string fault;
    TriangleMesh mesh;
    double waterplane = 1;  ///< of the solid that was meant, m^2
};

/// Open, inverted, with all triangles twice, two cubes through each other, with needle triangles, with the
/// vertices apart, with a triangle in the middle of nowhere, without volume, with NaN, with a wild index.
std::vector<FaultyMesh> faultyMeshes();

struct FaultyResult {
    bool refused;         ///< `remark` says why
    bool remarked;        ///< accepted, and `remark` names a fault
    std::string remark;   ///< the status, for people
    double balanceError;  ///< |displaced mass / mass - 1| at rest, for what the hull displaces by its own
                          ///< account
    double draftError;    ///< |draft - that of the solid that was meant|, m
    bool finite;
};

/// Floats a body of 300 kg with that hull for 60 s.
FaultyResult floatFaulty(const FaultyMesh& faulty, Floater floater, const Stepping& stepping = {});

}  // namespace bullet_buoyancy::scenes
