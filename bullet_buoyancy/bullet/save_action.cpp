#include <algorithm>
#include <array>
#include <cmath>

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "bullet_buoyancy/bullet/state_words.h"

namespace bullet_buoyancy {

namespace {

/// To be raised whenever what is saved, or its order, changes.
constexpr std::uint64_t version = 1;
constexpr std::uint64_t mark = 0x74617453796f7542;  // "BuoyStat"

constexpr std::size_t none = std::size_t(-1);

/// How a hull and a body are told from others.
struct Key {
    std::uint64_t hull;
    btScalar inverseMass;
    btVector3 inverseInertia, linearFactor, angularFactor;

    auto inertia() { return std::tie(inverseMass, inverseInertia, linearFactor, angularFactor); }
};

constexpr std::size_t inertiaWords = 1 + 3 * 3;
constexpr std::size_t bodyWords = 2 + inertiaWords + wordsOf<FloatingBody>() + wordsOf<RigidBodyState>();
constexpr std::size_t headWords = 9, checkWords = 1;
constexpr std::size_t idAt = 0, hullAt = 1, inertiaAt = 2, memoryAt = inertiaAt + inertiaWords;

struct Head {
    std::uint64_t itsMark = mark, itsVersion = version, precision = sizeof(btScalar), wordsOfBody = bodyWords;
    std::uint64_t bodies = 0;
    std::uint64_t pressure = 0, sums = 0;
    double tolerance = 0, time = 0;

    auto members() {
        return std::tie(itsMark, itsVersion, precision, wordsOfBody, bodies, pressure, sums, tolerance, time);
    }
};

static_assert(std::tuple_size_v<decltype(std::declval<Head&>().members())> == headWords);

/// Any word that is changed changes it.
class CheckSum {
public:
    void operator()(double number) {
        std::uint64_t word;
        std::memcpy(&word, &number, wordSize);
        (*this)(word);
    }
    void operator()(std::uint64_t word) {
        m_sum = (m_sum ^ word) * 0x9e3779b97f4a7c15u;  // odd: another word makes another sum
        m_sum ^= m_sum >> 32;
    }
    std::uint64_t value() const { return m_sum; }

private:
    std::uint64_t m_sum = 0;
};

std::uint64_t checkSumOf(const std::byte* bytes, std::size_t words) {
    CheckSum sum;
    WordReader reader(bytes);
    for (std::size_t i = 0; i < words; ++i) {
        std::uint64_t word;
        reader(word);
        sum(word);
    }
    return sum.value();
}

/// The same for hulls that were made of the same shape.
std::uint64_t fingerprint(const Hull& hull) {
    CheckSum sum;
    for (std::size_t size :
         {hull.mesh.vertices.size(), hull.mesh.triangles.size(), hull.spheres.size(), hull.solids.size()})
        sum(std::uint64_t(size));
    sum(hull.moments.volume);
    sum(hull.surfaceArea);
    sum(hull.bounds.radius);
    for (const Vec3* vector : {&hull.moments.firstMoment, &hull.bounds.centre, &hull.halfExtents})
        std::for_each(vector->data(), vector->data() + 3, std::ref(sum));
    std::for_each(hull.moments.secondMoment.data(), hull.moments.secondMoment.data() + 9, std::ref(sum));
    return sum.value();
}

Key keyOf(const FloatingBody& floating) {
    const btRigidBody& body = floating.body();
    return {fingerprint(floating.hull()), body.getInvMass(), body.getInvInertiaDiagLocal(),
            body.getLinearFactor(), body.getAngularFactor()};
}

Head headOf(const BuoyancySettings& settings, std::size_t bodies, double time) {
    Head head;
    head.bodies = bodies;
    head.pressure = std::uint64_t(settings.pressure);
    head.sums = std::uint64_t(settings.precision);
    head.tolerance = settings.tolerance;
    head.time = time;
    return head;
}

bool isSameInertia(const std::byte* saved, Key& key) {
    std::array<std::byte, inertiaWords * wordSize> bytes;
    WordWriter writer(bytes.data());
    visitAll(writer, key.inertia());
    return std::equal(bytes.begin(), bytes.end(), saved);
}

std::uint64_t wordAt(const std::byte* bytes, std::size_t place) {
    std::uint64_t word;
    WordReader reader(bytes + place * wordSize);
    reader(word);
    return word;
}

/// Which of the action's bodies is the state's next.
class Match {
public:
    explicit Match(const std::vector<FloatingBody>& bodies) : m_bodies(bodies) {}

    std::size_t next(std::uint64_t id) { return id == 0 ? nextWithoutId() : find(id); }

private:
    std::size_t nextWithoutId() {
        while (m_inOrder < m_bodies.size() && m_bodies[m_inOrder].id() != 0)
            ++m_inOrder;
        return m_inOrder < m_bodies.size() ? m_inOrder++ : none;
    }

    /// From the last one on, which is quick where the order is the same.
    std::size_t find(std::uint64_t id) {
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            if (++m_last >= m_bodies.size()) m_last = 0;
            if (m_bodies[m_last].id() == id) return m_last;
        }
        return none;
    }

    const std::vector<FloatingBody>& m_bodies;
    std::size_t m_inOrder = 0, m_last = none;
};

/// A state whose bytes are whole, against an action.
class Checked {
public:
    explicit Checked(const ActionState& state) : m_bytes(state.bytes) {}

    RestoreStatus against(const BuoyancySettings& settings, const std::vector<FloatingBody>& bodies) {
        if (const RestoreError error = readHead(); error != RestoreError::none) return {error};
        const Head own = headOf(settings, bodies.size(), 0);
        if (own.pressure != m_head.pressure || own.sums != m_head.sums || own.tolerance != m_head.tolerance)
            return {RestoreError::otherSettings};
        const RestoreStatus status = compareIds(bodies);
        return status ? compareBodies(bodies) : status;
    }

    const Head& head() const { return m_head; }

    const std::byte* body(std::size_t i) const {
        return m_bytes.data() + (headWords + i * bodyWords) * wordSize;
    }

private:
    RestoreError readHead() {
        const std::size_t words = m_bytes.size() / wordSize;
        if (words == 0 || wordAt(m_bytes.data(), 0) != mark) return RestoreError::notAState;
        if (words < headWords + checkWords) return RestoreError::damaged;
        WordReader reader(m_bytes.data());
        visitAll(reader, m_head.members());
        if (m_head.itsVersion != version) return RestoreError::otherVersion;
        if (m_head.precision != sizeof(btScalar)) return RestoreError::otherPrecision;
        if (m_head.wordsOfBody != bodyWords) return RestoreError::otherVersion;
        const std::size_t ofBodies = words - headWords - checkWords;
        const bool isWhole = m_bytes.size() % wordSize == 0 && ofBodies % bodyWords == 0 &&
                             ofBodies / bodyWords == m_head.bodies;
        if (!isWhole || wordAt(m_bytes.data(), words - 1) != checkSumOf(m_bytes.data(), words - 1))
            return RestoreError::damaged;
        return std::isfinite(m_head.time) ? RestoreError::none : RestoreError::damaged;
    }

    RestoreStatus compareIds(const std::vector<FloatingBody>& bodies) const {
        Match match(bodies);
        for (std::size_t i = 0; i < m_head.bodies; ++i) {
            const std::uint64_t id = wordAt(body(i), idAt);
            if (match.next(id) == none) return {RestoreError::otherBodies, i, id};
        }
        if (m_head.bodies < bodies.size()) return {RestoreError::otherBodies, std::size_t(m_head.bodies)};
        return {};
    }

    RestoreStatus compareBodies(const std::vector<FloatingBody>& bodies) const {
        Match match(bodies);
        for (std::size_t i = 0; i < m_head.bodies; ++i) {
            const std::uint64_t id = wordAt(body(i), idAt);
            FloatingBody scratch = bodies[match.next(id)];
            Key key = keyOf(scratch);
            if (wordAt(body(i), hullAt) != key.hull) return {RestoreError::otherHull, i, id};
            if (!isSameInertia(body(i) + inertiaAt * wordSize, key))
                return {RestoreError::otherInertia, i, id};
            WordReader reader(body(i) + memoryAt * wordSize);
            RigidBodyState bullets;
            visitNumbers(scratch, reader);
            visitNumbers(bullets, reader);
            if (!reader.isSound()) return {RestoreError::damaged, i, id};
        }
        return {};
    }

    const std::vector<std::byte>& m_bytes;
    Head m_head;
};

}  // namespace

void BuoyancyAction::save(ActionState& state) const {
    const std::size_t words = headWords + m_bodies.size() * bodyWords + checkWords;
    state.bytes.resize(words * wordSize);
    WordWriter writer(state.bytes.data());
    Head head = headOf(m_settings, m_bodies.size(), m_time);
    visitAll(writer, head.members());
    for (const FloatingBody& floating : m_bodies) {
        Key key = keyOf(floating);
        writer(floating.id());
        writer(key.hull);
        visitAll(writer, key.inertia());
        visitNumbers(floating, writer);
        const RigidBodyState bullets(floating.body());
        visitNumbers(bullets, writer);
    }
    writer(checkSumOf(state.bytes.data(), words - checkWords));
}

ActionState BuoyancyAction::save() const {
    ActionState state;
    save(state);
    return state;
}

RestoreStatus BuoyancyAction::restore(const ActionState& state) {
    Checked saved(state);
    const RestoreStatus status = saved.against(m_settings, m_bodies);
    if (!status) return status;
    m_time = saved.head().time;
    Match match(m_bodies);
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        FloatingBody& floating = m_bodies[match.next(wordAt(saved.body(i), idAt))];
        WordReader reader(saved.body(i) + memoryAt * wordSize);
        visitNumbers(floating, reader);
        RigidBodyState bullets;
        visitNumbers(bullets, reader);
        bullets.putInto(floating.body());
    }
    return {};
}

}  // namespace bullet_buoyancy
