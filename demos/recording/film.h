#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/hull/hull.h"
#include "bullet_buoyancy/water/water_field.h"
#include "recording/look.h"

namespace bullet_buoyancy::recording {

struct FilmDef {
    double rate = 30;     ///< frames a second, at most
    double seconds = 60;  ///< from the first frame on; what comes later is not filmed
    bool forces = false;  ///< with the centres of buoyancy and the forces of the water
    bool slides = false;  ///< each frame stands until the next; else the film glides from one to the other
};

/// What the water does to a body.
struct WaterForce {
    Vec3 centre = Vec3::Zero();  ///< of buoyancy, m
    Vec3 force = Vec3::Zero();   ///< over the weight of water that the whole hull displaces
};

/// A body of a film, in the film's axes.
struct FilmedBody {
    std::string name;
    Look look;
    std::shared_ptr<const Hull> hull;
    std::size_t firstFrame;          ///< in which it is seen
    std::vector<Pose> poses;         ///< one a frame from there on, until it was taken away
    std::vector<WaterForce> forces;  ///< likewise, where the film has them
};

/// Where the water's surface is seen, in the water's frame: a rectangle.
struct Stage {
    Vec2 centre = Vec2::Zero();  ///< m
    Vec2 reach = Vec2::Zero();   ///< to each side, m; zero: no water is seen
};

/// The surface over the stage, on a regular grid, x fastest: elevation (m) and its slopes along the water
/// frame's x and y, a row a node.
using FilmedSurface = Eigen::Array<float, Eigen::Dynamic, 3>;

/// A scene over time: its bodies, as long as they are on the stage, and the surface of the water. Film axes:
/// x and z horizontal, y up, from the origin of the water's frame.
class Film {
public:
    static constexpr int waterNodes = 49;  ///< of the surface along either side

    Film(const FilmDef& def, const WaterFrame& frame, const Stage& stage = {});

    const FilmDef& def() const { return m_def; }
    const Stage& stage() const { return m_stage; }

    /// Returns its number. It is seen from the next frame on in which it is shown.
    std::size_t addBody(std::string name, Look look, std::shared_ptr<const Hull> hull);

    /// Whether the film is to have a frame of this moment (s); times must not fall.
    bool isDue(double time) const;

    /// The surface of `water` is looked at at its time `waterTime`, about `centre` of its frame; what is seen
    /// there stands on the stage.
    void beginFrame(double time, const WaterField& water, double waterTime, const Vec2& centre);
    void beginFrame(double time, const WaterField& water) { beginFrame(time, water, time, m_stage.centre); }

    /// A frame without water.
    void beginFrame(double time) { m_times.push_back(time); }

    /// In the frame that was begun last. `pose` and `force` are the world's.
    void show(std::size_t body, const Pose& pose, const WaterForce& force = {});

    const std::vector<double>& times() const { return m_times; }  ///< of the frames, s
    const std::vector<FilmedBody>& bodies() const { return m_bodies; }
    const std::vector<FilmedSurface>& surfaces() const { return m_surfaces; }  ///< one a frame, or none

    /// Node `index` of the surface when it is flat, in the film's axes.
    Vec3 waterNode(int index) const;

    /// Whether there is water to be seen about a body at a pose of the film; where no water is, always.
    bool isOnStage(const FilmedBody& body, const Pose& pose) const;

    /// The frame nearest to a time. There must be one.
    std::size_t frameAt(double time) const;

private:
    FilmDef m_def;
    Vec3 m_originWorld;
    Mat3 m_filmFromWorld;
    Stage m_stage;
    std::vector<double> m_times;
    std::vector<FilmedBody> m_bodies;
    std::vector<FilmedSurface> m_surfaces;
};

}  // namespace bullet_buoyancy::recording
