#include "recording/water_modes.h"

#include <cmath>

namespace bullet_buoyancy::recording {

namespace {

/// The same sum with weights from 0 to 1.
void normalizeWeights(WaterModes& modes) {
    for (Eigen::Index i = 0; i < modes.weights.cols(); ++i) {
        auto weights = modes.weights.col(i);
        const float least = weights.minCoeff(), range = weights.maxCoeff() - least;
        FilmedSurface& mode = modes.modes[std::size_t(i)];
        modes.rest += least * mode;
        mode *= range;
        weights = ((weights - least) / range).cwiseMin(1.0F);
    }
}

}  // namespace

WaterModes findWaterModes(const std::vector<FilmedSurface>& surfaces, double tolerance) {
    const Eigen::Index nodes = surfaces.front().rows(), frames = Eigen::Index(surfaces.size());
    WaterModes result;
    result.rest = surfaces.front();
    // A column a frame: elevations, slopes along x, slopes along y, less what the modes so far make of them.
    Eigen::MatrixXf left(3 * nodes, frames);
    for (Eigen::Index f = 0; f < frames; ++f)
        Eigen::Map<FilmedSurface>(left.col(f).data(), nodes, 3) = surfaces[std::size_t(f)] - result.rest;

    std::vector<Eigen::VectorXf> weights;
    Eigen::Index node = 0, frame = 0;
    while (std::abs(left.topRows(nodes).cwiseAbs().maxCoeff(&node, &frame)) > float(tolerance) &&
           Eigen::Index(weights.size()) < frames) {
        const Eigen::VectorXf mode = left.col(frame) / std::abs(left(node, frame));
        const auto heights = mode.head(nodes);
        weights.push_back(left.topRows(nodes).transpose() * heights / heights.squaredNorm());
        left.noalias() -= mode * weights.back().transpose();
        result.modes.push_back(Eigen::Map<const FilmedSurface>(mode.data(), nodes, 3));
    }
    result.weights.resize(frames, Eigen::Index(weights.size()));
    for (std::size_t i = 0; i < weights.size(); ++i)
        result.weights.col(Eigen::Index(i)) = weights[i];
    normalizeWeights(result);
    return result;
}

}  // namespace bullet_buoyancy::recording
