#pragma once

#include <functional>

namespace bullet_buoyancy::scenes {

class FloatScene;

/// Looks on: for as long as it lives, `look` is called before the first step and after each step of every
/// `FloatScene` of this thread, whoever made it. Several may look on; the last one to come goes first:
/// asserted.
class SceneWatch {
public:
    using Look = std::function<void(const FloatScene&)>;

    explicit SceneWatch(Look look);
    ~SceneWatch();
    SceneWatch(const SceneWatch&) = delete;
    SceneWatch& operator=(const SceneWatch&) = delete;

    /// Has the scene looked at by all who look on.
    static void show(const FloatScene& scene);

private:
    Look m_look;
    const SceneWatch* m_other;  // who came before
};

}  // namespace bullet_buoyancy::scenes
