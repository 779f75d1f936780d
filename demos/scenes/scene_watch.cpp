#include "scenes/scene_watch.h"

#include <cassert>

namespace bullet_buoyancy::scenes {

namespace {

thread_local const SceneWatch* last = nullptr;

}  // namespace

SceneWatch::SceneWatch(Look look) : m_look(std::move(look)), m_other(last) {
    last = this;
}

SceneWatch::~SceneWatch() {
    assert(last == this);
    last = m_other;
}

void SceneWatch::show(const FloatScene& scene) {
    for (const SceneWatch* watch = last; watch; watch = watch->m_other)
        watch->m_look(scene);
}

}  // namespace bullet_buoyancy::scenes
