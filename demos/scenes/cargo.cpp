#include "scenes/cargo.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/bullet/convert.h"

namespace bullet_buoyancy::scenes {

namespace {

/// Of Bullet's solver, whose usual ten let a stack of ten crates fall over on solid ground at 1/60 s.
constexpr int solverIterations = 100;

struct Loading {
    Vec3 raftSize;
    double raftMass;  // kg
    Vec3 pieceSize;
    double pieceMass;  // kg
    int pieces;
    double seconds;
};

double totalMass(const Loading& loading) {
    return loading.raftMass + loading.pieces * loading.pieceMass;
}

/// Of a piece's centre above the raft's.
double heightOnRaft(const Loading& loading, int piece) {
    return (loading.raftSize.z() + loading.pieceSize.z()) / 2 + piece * loading.pieceSize.z();
}

btRigidBody& addBox(FloatScene& scene, const Vec3& size, double mass, double height) {
    const Pose pose{Vec3(0, 0, height), Eigen::Quaterniond::Identity()};
    btRigidBody& box = scene.addBody(std::make_unique<btBoxShape>(toBullet(size / 2)), mass, pose);
    scene.floatBody(box);
    return box;
}

CargoResult ride(const Loading& loading, Floater floater, const Stepping& stepping) {
    SceneDef def;
    def.floater = floater;
    FloatScene scene(def);
    scene.world().getSolverInfo().m_numIterations = solverIterations;
    const double displaced = totalMass(loading) / scene.water().density();
    const Vec3& size = loading.raftSize;
    const double raftHeight = size.z() / 2 - displaced / (size.x() * size.y());
    btRigidBody& raft = addBox(scene, size, loading.raftMass, raftHeight);
    std::vector<btRigidBody*> pieces;
    for (int i = 0; i < loading.pieces; ++i)
        pieces.push_back(
            &addBox(scene, loading.pieceSize, loading.pieceMass, raftHeight + heightOnRaft(loading, i)));
    scene.run(loading.seconds, stepping.dt, stepping.substeps);

    CargoResult result{0, 0, 0, 0, isFinite(scene, raft)};
    result.displacementError = std::abs(scene.report(raft).submergedVolume / displaced - 1);
    result.tilt = std::acos(std::clamp(upInBody(raft, scene.water()).z(), -1.0, 1.0));
    const Pose deck = poseOf(raft);
    for (int i = 0; i < loading.pieces; ++i) {
        const btRigidBody& piece = *pieces[std::size_t(i)];
        result.finite = result.finite && isFinite(scene, piece);
        const Vec3 onDeck = deck.orientation.conjugate() * (poseOf(piece).position - deck.position);
        const double shift = onDeck.head<2>().norm(), lift = std::abs(onDeck.z() - heightOnRaft(loading, i));
        result.worstShift = std::max(result.worstShift, shift / loading.pieceSize.x());
        result.worstHeightError = std::max(result.worstHeightError, lift / loading.pieceSize.z());
    }
    return result;
}

}  // namespace

CargoResult stackCratesOnRaft(Floater floater, const Stepping& stepping) {
    return ride({{8, 8, 1}, 19200, {0.8, 0.8, 0.8}, 150, 10, 20}, floater, stepping);
}

CargoResult loadInflatableRaft(Floater floater, const Stepping& stepping) {
    return ride({{3, 1.5, 0.4}, 30, {0.8, 0.8, 0.6}, 300, 1, 60}, floater, stepping);
}

}  // namespace bullet_buoyancy::scenes
