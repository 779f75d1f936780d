#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "bullet_buoyancy/bullet/convert.h"
#include "recording/world_film.h"
#include "recording/write_gltf.h"
#include "scenes/flotsam.h"
#include "scenes/scene_watch.h"
#include "scenes/sea.h"
#include "scenes/study_hulls.h"
#include "support/film_file.h"

namespace bullet_buoyancy::tests {
namespace {

using namespace recording;
using namespace scenes;

/// Of single precision, in which the file has its numbers, a few metres from the origin.
constexpr double rounding = 1e-6;

std::string fileFor(const std::string& name) {
    return ::testing::TempDir() + name + ".glb";
}

/// As read after it was written.
std::unique_ptr<FilmFile> written(const Film& film, const std::string& name) {
    EXPECT_EQ(writeGltf(film, fileFor(name)), "");
    auto file = std::make_unique<FilmFile>(fileFor(name));
    EXPECT_TRUE(file->isRead()) << file->error();
    return file;
}

Pose at(const Vec3& position) {
    return {position, Eigen::Quaterniond::Identity()};
}

std::shared_ptr<const Hull> unitCube() {
    return makeHull(boxMesh(Vec3::Ones())).hull;
}

TEST(Recording, CubeMovesInTheFileAsInTheSimulation) {
    constexpr double ratio = 0.9, dt = 1.0 / 60, seconds = 25;
    FloatScene scene;
    const Pose start{Vec3(0.3, -0.2, 1.5), Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vec3::UnitX()))};
    const btRigidBody& cube = scene.addFloatingBox(Vec3::Ones(), ratio, start);
    WorldFilm film{FilmDef()};
    std::vector<Pose> simulated{start};
    {
        const SceneWatch watch([&](const FloatScene& seen) { film.look(seen); });
        while (scene.time() < seconds - dt / 2) {
            scene.step(dt);
            simulated.push_back(poseOf(cube));
        }
    }
    const auto file = written(*film.film(), "cube");
    ASSERT_TRUE(file->animation());
    EXPECT_NEAR(file->secondsOf(file->animation()->mDuration), seconds, rounding * seconds);
    ASSERT_TRUE(file->node("box 1") && file->node("water"));
    EXPECT_EQ(file->scene().mNumMeshes, 2U);

    const aiNodeAnim& channel = *file->channel("box 1");
    ASSERT_EQ(channel.mNumPositionKeys, unsigned(seconds * 30) + 1);
    ASSERT_EQ(channel.mNumRotationKeys, channel.mNumPositionKeys);
    const Eigen::Quaterniond filmFromWorld(Eigen::AngleAxisd(-pi / 2, Vec3::UnitX()));
    for (unsigned key = 0; key < channel.mNumPositionKeys; ++key) {
        const double time = file->secondsOf(channel.mPositionKeys[key].mTime);
        EXPECT_NEAR(time, key / 30.0, rounding * seconds);
        const Pose& pose = simulated[std::size_t(std::lround(time / dt))];
        const Pose seen = poseAt(channel, key);
        EXPECT_LT((seen.position - filmFromWorld * pose.position).norm(), rounding);
        EXPECT_LT(seen.orientation.angularDistance(filmFromWorld * pose.orientation), 1e-3);
        EXPECT_LT(
            (seen.orientation.toRotationMatrix() - (filmFromWorld * pose.orientation).toRotationMatrix())
                .cwiseAbs()
                .maxCoeff(),
            4 * rounding);
    }

    // So heavy a cube floats flat, at a draught of its ratio; what is left of its swing by then is less.
    double lowest = 1;
    const Pose last = poseAt(channel, channel.mNumPositionKeys - 1);
    for (const Vec3& vertex : trianglesOf(file->meshOf(*file->node("box 1"))).vertices)
        lowest = std::min(lowest, (last.position + last.orientation * vertex).y());
    EXPECT_NEAR(lowest, -ratio, 1e-3);
    for (const Vec3& vertex : trianglesOf(file->meshOf(*file->node("water"))).vertices)
        EXPECT_EQ(vertex.y(), 0);
}

TEST(Recording, ForceIsAsLongAsTheBodyDisplaces) {
    constexpr double ratio = 0.1;
    FloatScene scene;
    scene.addFloatingBox(Vec3::Ones(), ratio, at({0, 0, 0.5 - ratio}));
    FilmDef def;
    def.forces = true;
    WorldFilm film(def);
    scene.run(2, 1.0 / 60);
    film.look(scene);
    scene.step(1.0 / 30);
    film.look(scene);
    const auto file = written(*film.film(), "forces");
    const aiNodeAnim* arrow = file->channel("box 1: force");
    ASSERT_TRUE(arrow);
    const double diameter = std::sqrt(3.0);
    EXPECT_NEAR(double(arrow->mScalingKeys[1].mValue.y), ratio * diameter, 1e-3);
    EXPECT_LT((poseAt(*arrow, 1).orientation * Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-3);
    EXPECT_NEAR(double(arrow->mPositionKeys[1].mValue.y), -ratio / 2, 1e-3);
}

/// The pieces keep the volume of their hulls: polyhedra to rounding; a ball of 1280 triangles and a cylinder
/// of 48 sides are smaller by their tessellation, (2 pi / 48)^2 / 6 of a cylinder and less than 1 % of a
/// ball.
TEST(Recording, MeshesDisplaceWhatHullsDo) {
    FlotsamDef def;
    def.bodies = 80;
    const FlatWater water(WaterFrame::yUp());
    const FlotsamScene scene(def, water);
    std::size_t i = 0;
    WorldFilm film(FilmDef(), [&](const btRigidBody&) {
        const FlotsamPiece& piece = scene.pieces()[i++];
        return Cast{nameOf(piece.kind), Look::wood, piece.hull};
    });
    film.look({scene.world(), water, 0, {}});
    const auto file = written(*film.film(), "flotsam");
    EXPECT_FALSE(file->animation());
    int kinds = 0;
    for (std::size_t piece = 0; piece < scene.pieces().size(); ++piece) {
        const FlotsamPiece& known = scene.pieces()[piece];
        const aiNode* node = file->node(nameOf(known.kind) + (' ' + std::to_string(piece + 1)));
        ASSERT_TRUE(node);
        const double volume = volumeOf(trianglesOf(file->meshOf(*node)));
        const bool isRound = !known.hull->spheres.empty() || !known.hull->solids.empty();
        EXPECT_LT(volume, (1 + 1e-5) * known.hull->moments.volume) << nameOf(known.kind);
        EXPECT_GT(volume, (1 - (isRound ? 0.01 : 1e-5)) * known.hull->moments.volume) << nameOf(known.kind);
        kinds |= 1 << int(known.kind);

        const Pose pose = toPose(known.body->getWorldTransform());
        aiVector3D scale, place;
        aiQuaternion turn;
        node->mTransformation.Decompose(scale, turn, place);
        EXPECT_LT((toVec3(place) - pose.position).norm(), 10 * rounding);
        EXPECT_LT((toQuaternion(turn).toRotationMatrix() - pose.worldFromBody()).cwiseAbs().maxCoeff(),
                  10 * rounding);
    }
    EXPECT_EQ(kinds, (1 << flotsamKinds) - 1);
}

TEST(Recording, BodiesOfOneShapeShareTheMesh) {
    FloatScene scene;
    for (int i = 0; i < 5; ++i)
        scene.addFloatingBox(Vec3::Ones(), 0.5, at({2.0 * i, 0, 0}));
    WorldFilm film{FilmDef()};
    film.look(scene);
    const auto file = written(*film.film(), "shared");
    EXPECT_EQ(file->scene().mRootNode->mNumChildren, 6U);
    EXPECT_EQ(file->scene().mNumMeshes, 2U);
}

/// One number for the whole of a mesh: how far it is from the field.
struct Deviation {
    double height, normal;
};

/// Of the file's water in one of its keys.
Deviation deviationOf(const aiMesh& mesh, const aiMeshMorphKey& key, const WaterField& water, double time) {
    Deviation worst{0, 0};
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        Vec3 vertex = toVec3(mesh.mVertices[i]), normal = toVec3(mesh.mNormals[i]);
        for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k) {
            const aiAnimMesh& target = *mesh.mAnimMeshes[key.mValues[k]];
            // Assimp has added the rest to what a target says.
            vertex += key.mWeights[k] * (toVec3(target.mVertices[i]) - toVec3(mesh.mVertices[i]));
            normal += key.mWeights[k] * (toVec3(target.mNormals[i]) - toVec3(mesh.mNormals[i]));
        }
        Eigen::ArrayX2d point(1, 2);
        point << vertex.x(), -vertex.z();
        Eigen::ArrayX3d sample(1, 3);
        water.sampleSurface(point, time, sample);
        const Vec3 expected = Vec3(-sample(0, 1), 1, sample(0, 2)).normalized();
        worst.height = std::max(worst.height, std::abs(vertex.y() - sample(0, 0)));
        worst.normal = std::max(worst.normal, (normal.normalized() - expected).norm());
    }
    return worst;
}

TEST(Recording, WaterInTheFileIsTheField) {
    SeaDef seaDef;
    seaDef.spreading = 10;
    const Sea sea(seaDef);
    constexpr double seconds = 8;
    FilmDef def;
    def.rate = 15;
    Film film(def, sea.water().frame(), {Vec2(3, -5), Vec2(12, 8)});
    const std::size_t body = film.addBody("cube", Look::wood, unitCube());
    for (int i = 0; i <= 15 * seconds; ++i) {
        film.beginFrame(i / 15.0, sea.water());
        film.show(body, at(Vec3::Zero()));
    }
    const auto file = written(film, "waves");
    const aiMesh& mesh = file->meshOf(*file->node("water"));
    ASSERT_EQ(mesh.mNumVertices, unsigned(Film::waterNodes * Film::waterNodes));
    ASSERT_EQ(file->animation()->mNumMorphMeshChannels, 1U);
    const aiMeshMorphAnim& channel = *file->animation()->mMorphMeshChannels[0];
    ASSERT_EQ(channel.mNumKeys, unsigned(15 * seconds) + 1);
    EXPECT_LT(mesh.mNumAnimMeshes, channel.mNumKeys / 2);
    for (unsigned key = 0; key < channel.mNumKeys; key += 7) {
        const double time = file->secondsOf(channel.mKeys[key].mTime);
        const Deviation worst = deviationOf(mesh, channel.mKeys[key], sea.water(), time);
        EXPECT_LT(worst.height, waterTolerance + 20 * rounding);
        // The slope of what is left out, of which the shortest waves are some metres long.
        EXPECT_LT(worst.normal, 0.01);
    }
}

TEST(Recording, WhatComesAndGoesHasNoSizeMeanwhile) {
    Film film(FilmDef(), WaterFrame::zUp());
    const std::size_t whole = film.addBody("whole", Look::wood, unitCube()),
                      part = film.addBody("part", Look::steel, unitCube());
    for (int frame = 0; frame < 6; ++frame) {
        film.beginFrame(frame);
        film.show(whole, at(Vec3(frame, 0, 0)));
        if (frame == 2 || frame == 3) film.show(part, at(Vec3(0, frame, 0)));
    }
    const auto file = written(film, "coming");
    const aiNodeAnim& channel = *file->channel("part");
    ASSERT_EQ(channel.mNumScalingKeys, 6U);
    for (unsigned frame = 0; frame < 6; ++frame)
        EXPECT_EQ(channel.mScalingKeys[frame].mValue.x, frame == 2 || frame == 3 ? 1 : 0);
    EXPECT_EQ(toVec3(channel.mPositionKeys[3].mValue), Vec3(0, 0, -3));
    EXPECT_EQ(file->channel("whole")->mPositionKeys[5].mValue.x, 5);
}

TEST(Recording, WhatLeavesTheWaterIsNotSeen) {
    const FlatWater water(WaterFrame::zUp());
    Film film(FilmDef(), water.frame(), {Vec2(1, 4), Vec2(3, 2)});
    const std::size_t body = film.addBody("cube", Look::wood, unitCube());
    for (int frame = 0; frame < 7; ++frame) {
        film.beginFrame(frame, water);
        film.show(body, at(Vec3(frame, 4, 0)));
    }
    const auto file = written(film, "leaving");
    const aiNodeAnim& channel = *file->channel("cube");
    ASSERT_EQ(channel.mNumScalingKeys, 7U);
    // The water ends at x = 4; the cube reaches to sqrt(3) / 2 about its centre.
    for (unsigned frame = 0; frame < 7; ++frame)
        EXPECT_EQ(channel.mScalingKeys[frame].mValue.x, frame < 5 ? 1 : 0);
}

/// Up is y in the file, whatever it is in the world.
TEST(Recording, UpIsUp) {
    const Vec3 origin(100, 20, 3);
    for (const WaterFrame& frame :
         {WaterFrame::yUp(origin), WaterFrame::zUp(origin), WaterFrame::fromUp(origin, Vec3(1, 2, 3))}) {
        Film film(FilmDef(), frame);
        const std::size_t body = film.addBody("cube", Look::wood, unitCube());
        film.beginFrame(0);
        film.show(body, {origin + 2 * frame.upWorld(), Eigen::Quaterniond(frame.worldFromFrame())});
        const Pose seen = film.bodies()[body].poses.front();
        EXPECT_LT((seen.position - 2 * Vec3::UnitY()).norm(), 1e-12);
        EXPECT_LT((seen.orientation * Vec3::UnitZ() - Vec3::UnitY()).norm(), 1e-12);
    }
}

TEST(Recording, TurnsNeverGoRound) {
    Film film(FilmDef(), WaterFrame::zUp());
    const std::size_t body = film.addBody("cube", Look::wood, unitCube());
    for (int frame = 0; frame <= 200; ++frame) {
        film.beginFrame(frame / 30.0);
        // By way of the matrix, as from Bullet: the sign of the quaternion is lost.
        const Mat3 turn(Eigen::AngleAxisd(0.1 * frame, Vec3(1, 2, 3).normalized()));
        film.show(body, {Vec3::Zero(), Eigen::Quaterniond(turn)});
    }
    const auto file = written(film, "turns");
    const aiNodeAnim& channel = *file->channel("cube");
    for (unsigned key = 1; key < channel.mNumRotationKeys; ++key) {
        const Eigen::Quaterniond before = poseAt(channel, key - 1).orientation,
                                 now = poseAt(channel, key).orientation;
        EXPECT_NEAR(now.norm(), 1, rounding);
        EXPECT_GT(before.dot(now), 0.99);
    }
}

TEST(Recording, FramesAreDueAtTheRateAndForTheTime) {
    FilmDef def;
    def.rate = 10;
    def.seconds = 2;
    Film film(def, WaterFrame::zUp());
    for (int i = 0; i < 1000; ++i)
        if (film.isDue(5 + i / 60.0)) film.beginFrame(5 + i / 60.0);
    ASSERT_EQ(film.times().size(), 21U);
    for (std::size_t i = 0; i < film.times().size(); ++i)
        EXPECT_NEAR(film.times()[i], 5 + double(i) / 10, 1e-9);
    EXPECT_EQ(film.frameAt(5.52), 5U);
    EXPECT_EQ(film.frameAt(1e9), 20U);
}

TEST(Recording, WhatCannotBeWrittenIsSaid) {
    Film film(FilmDef(), WaterFrame::zUp());
    EXPECT_NE(writeGltf(film, fileFor("empty")), "");
    EXPECT_FALSE(std::filesystem::exists(fileFor("empty")));
    const std::size_t body = film.addBody("cube", Look::wood, unitCube());
    film.beginFrame(0);
    film.show(body, at(Vec3::Zero()));
    EXPECT_NE(writeGltf(film, ::testing::TempDir() + "no such directory/film.glb"), "");
    EXPECT_EQ(writeGltf(film, fileFor("still")), "");
    EXPECT_FALSE(std::filesystem::exists(fileFor("still") + ".part"));
}

TEST(Flotsam, StartsApartAndFloats) {
    FlotsamDef def;
    def.bodies = 50;
    const FlatWater water(WaterFrame::zUp(), {seaWaterDensity});
    FlotsamScene scene(def, water);
    const std::vector<FlotsamPiece>& pieces = scene.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double distance = double((pieces[i].body->getWorldTransform().getOrigin() -
                                            pieces[j].body->getWorldTransform().getOrigin())
                                               .length());
            EXPECT_GT(distance, pieces[i].hull->bounds.radius + pieces[j].hull->bounds.radius - 1e-5);
        }
    for (int i = 0; i < 60 * 40; ++i)
        scene.step(1.0 / 60);
    double displaced = 0, mass = 0;
    for (const FlotsamPiece& piece : pieces) {
        const BodyReport report = scene.buoyancy().report(*piece.body);
        // One may be held under by others, or lie on a raft.
        EXPECT_LT(std::abs(heightAboveWater(*piece.body, water)), 2) << nameOf(piece.kind);
        displaced += report.submergedVolume * water.density();
        mass += 1 / double(piece.body->getInvMass());
    }
    // They have come to rest but for what still bumps and rolls.
    EXPECT_NEAR(displaced / mass, 1, 0.01);
}

TEST(Flotsam, IsTheSameForTheSameSeed) {
    const FlatWater water(WaterFrame::zUp());
    FlotsamDef def;
    def.bodies = 12;
    def.seed = 7;
    FlotsamScene a(def, water), b(def, water);
    def.seed = 8;
    FlotsamScene other(def, water);
    for (int i = 0; i < 120; ++i)
        for (FlotsamScene* scene : {&a, &b, &other})
            scene->step(1.0 / 60);
    int differing = 0;
    for (std::size_t i = 0; i < a.pieces().size(); ++i) {
        const btVector3 place = a.pieces()[i].body->getWorldTransform().getOrigin();
        EXPECT_EQ(place, b.pieces()[i].body->getWorldTransform().getOrigin());
        differing += place != other.pieces()[i].body->getWorldTransform().getOrigin();
    }
    EXPECT_GT(differing, 10);
}

}  // namespace
}  // namespace bullet_buoyancy::tests
