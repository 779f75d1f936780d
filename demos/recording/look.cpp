#include "recording/look.h"

#include <array>

namespace bullet_buoyancy::recording {

const Material& materialOf(Look look) {
    static const std::array<Material, lookCount> materials{{{"wood", {0.42, 0.22, 0.09}, 0.8, 0},
                                                            {"pale wood", {0.62, 0.42, 0.22}, 0.8, 0},
                                                            {"dark wood", {0.2, 0.09, 0.04}, 0.7, 0},
                                                            {"orange", {0.9, 0.22, 0.02}, 0.4, 0},
                                                            {"red", {0.6, 0.03, 0.03}, 0.4, 0},
                                                            {"yellow", {0.9, 0.6, 0.03}, 0.4, 0},
                                                            {"blue", {0.03, 0.12, 0.45}, 0.4, 0},
                                                            {"white", {0.8, 0.8, 0.78}, 0.4, 0},
                                                            {"steel", {0.45, 0.47, 0.5}, 0.35, 1},
                                                            {"stone", {0.3, 0.29, 0.27}, 0.9, 0},
                                                            {"sand", {0.6, 0.48, 0.3}, 0.95, 0}}};
    return materials[std::size_t(look)];
}

}  // namespace bullet_buoyancy::recording
