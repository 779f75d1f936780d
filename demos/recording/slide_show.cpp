#include "recording/slide_show.h"

#include <algorithm>

namespace bullet_buoyancy::recording {

namespace {

FilmDef asSlides(FilmDef def) {
    def.slides = true;
    def.forces = false;
    def.rate = 1;
    return def;
}

}  // namespace

SlideShow::SlideShow(FilmDef def, double reach)
    : m_film(asSlides(def), WaterFrame::zUp(), {Vec2::Zero(), Vec2::Constant(reach)}) {}

void SlideShow::show(const std::string& name, Look look, const std::shared_ptr<const Hull>& hull,
                     const WaterField& water, const std::vector<scenes::StudyCase>& cases, int count) {
    const std::size_t body = m_film.addBody(name, look, hull);
    for (std::size_t i = 0; i < std::min(cases.size(), std::size_t(count)); ++i) {
        const double time = double(m_film.times().size());
        if (!m_film.isDue(time)) return;
        Pose pose = cases[i].pose;
        const Vec2 place = pose.position.head<2>();
        pose.position.head<2>().setZero();
        m_film.beginFrame(time, water, cases[i].time, place);
        m_film.show(body, pose);
    }
}

}  // namespace bullet_buoyancy::recording
