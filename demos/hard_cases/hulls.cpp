#include "hard_cases/hard_case.h"
#include "hard_cases/names.h"
#include "scenes/capsizing.h"
#include "scenes/faulty_meshes.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

/// Upright to what drag leaves of a roll after two minutes; capsized is past lying on the side.
void addCapsizing(std::vector<HardCase>& cases) {
    for (double raised : {0.25, 0.35, 0.8}) {
        CapsizeDef def;
        def.raised = raised;
        const double gm = heelHull({raised, 0, 0, Floater::library, {}}).metacentricHeight;
        cases.push_back({std::string(gm > 0 ? "stiff" : "top-heavy") + " hull, GM " + text(gm) + " m", "",
                         true, [def, gm](Floater floater) {
                             CapsizeDef floated = def;
                             floated.floater = floater;
                             const CapsizeResult result = heelHull(floated);
                             std::vector<Quantity> quantities{mustBe("finite", result.finite)};
                             if (gm > 0) {
                                 quantities.push_back({"most heel", "rad", result.mostHeel, 1.1 * def.heel});
                                 quantities.push_back({"heel in the end", "rad", result.endHeel, 0.01});
                             } else {
                                 quantities.push_back(mustBe("capsized", result.endHeel > pi / 2));
                             }
                             return quantities;
                         }});
    }
}

/// A faulty mesh is refused, or its fault is named, or it floats like the solid that was meant; whatever
/// floats is in balance with the water that it displaces.
void addFaultyMeshes(std::vector<HardCase>& cases) {
    constexpr double draftLimit = 1e-3;  // m: what is left of its heave after a minute
    for (const FaultyMesh& faulty : faultyMeshes())
        cases.push_back({"faulty mesh", faulty.fault, true, [faulty](Floater floater) {
                             const FaultyResult result = floatFaulty(faulty, floater);
                             const bool named = result.refused || result.remarked;
                             return std::vector<Quantity>{
                                 mustBe("finite", result.finite),
                                 mustBe("named, nor right draft", named || result.draftError < draftLimit),
                                 {"out of balance by", "weight", result.balanceError, 2e-3}};
                         }});
}

}  // namespace

void addHulls(std::vector<HardCase>& cases) {
    addCapsizing(cases);
    addFaultyMeshes(cases);
}

}  // namespace bullet_buoyancy::demo
