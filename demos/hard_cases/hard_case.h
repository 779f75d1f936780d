#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenes/float_scene.h"

namespace bullet_buoyancy::demo {

/// One measured number that must not be above its limit.
struct Quantity {
    std::string what;
    std::string unit;
    double value;
    double limit;  ///< the reason stands where it is set

    bool passes() const { return value <= limit; }  // false for NaN
};

/// A condition as a quantity: 1 where it is broken.
inline Quantity mustBe(const std::string& what, bool holds) {
    return {"not " + what, "", holds ? 0.0 : 1.0, 0};
}

/// A scene that is hard on a floater, and what is measured in it.
struct HardCase {
    std::string group;  ///< family and what the cases of one summary have in common: "grid/ratio 0.5"
    std::string name;   ///< of the case in its group; empty: its only one
    bool quick;         ///< belongs to the thinned run
    std::function<std::vector<Quantity>(scenes::Floater)> measure;

    std::string fullName() const { return name.empty() ? group : group + "/" + name; }
};

/// The families, each to be appended.
void addDroppedBodies(std::vector<HardCase>& cases);
void addMotions(std::vector<HardCase>& cases);
void addContacts(std::vector<HardCase>& cases);
void addHulls(std::vector<HardCase>& cases);
void addSurroundings(std::vector<HardCase>& cases);

}  // namespace bullet_buoyancy::demo
