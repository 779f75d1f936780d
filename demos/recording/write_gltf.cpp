#include "recording/write_gltf.h"

#include <filesystem>
#include <map>

#include "bullet_buoyancy/version.h"
#include "recording/gltf_buffer.h"
#include "recording/shaded_mesh.h"
#include "recording/water_mesh.h"
#include "recording/water_modes.h"

namespace bullet_buoyancy::recording {

namespace {

using Numbers = std::vector<float>;

void append(Numbers& numbers, const Vec3& v) {
    for (double component : v)
        numbers.push_back(float(component));
}

void append(Numbers& numbers, const Eigen::Quaterniond& q) {
    for (double component : {q.x(), q.y(), q.z(), q.w()})
        numbers.push_back(float(component));
}

tinygltf::Material gltfMaterial(const std::string& name, const Vec3& colour, double opacity, double roughness,
                                double metallic) {
    tinygltf::Material material;
    material.name = name;
    material.pbrMetallicRoughness.baseColorFactor = {colour.x(), colour.y(), colour.z(), opacity};
    material.pbrMetallicRoughness.roughnessFactor = roughness;
    material.pbrMetallicRoughness.metallicFactor = metallic;
    return material;
}

/// Turns an arrow along y into a direction.
Eigen::Quaterniond turnOfArrow(const Vec3& direction) {
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), direction);
}

class GltfWriter {
public:
    explicit GltfWriter(const Film& film) : m_film(film) {}

    tinygltf::Model write();

private:
    int addMaterial(const tinygltf::Material& material);
    int materialOfLook(Look look);
    int addMesh(const std::string& name, const ShadedMesh& shaded, int material);
    int meshOf(const FilmedBody& body);
    int addNode(const std::string& name, int mesh);
    void addChannel(int node, const char* path, const Numbers& keys, int type, bool steps = false);
    void addPresence(int node, const FilmedBody& body);
    void addBody(const FilmedBody& body);
    void addForce(const FilmedBody& body);
    void addWater();
    void addFlatWater(int material, const FilmedSurface& surface);
    void addWaves(int material);
    int addVertices(const Numbers& numbers) {
        return m_buffer.addFloats(numbers, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
    }

    const Film& m_film;
    tinygltf::Model m_model;
    GltfBuffer m_buffer{m_model};
    tinygltf::Animation m_animation;
    int m_times = -1;  // accessor of the times of all frames
    std::map<Look, int> m_looks;
    std::map<std::pair<Look, Numbers>, int> m_meshes;  // by look and vertices
    int m_centreMesh = -1, m_arrowMesh = -1;
};

int GltfWriter::addMaterial(const tinygltf::Material& material) {
    m_model.materials.push_back(material);
    return int(m_model.materials.size()) - 1;
}

int GltfWriter::materialOfLook(Look look) {
    const auto [known, isNew] = m_looks.try_emplace(look, 0);
    const Material& m = materialOf(look);
    if (isNew) known->second = addMaterial(gltfMaterial(m.name, m.colour, 1, m.roughness, m.metallic));
    return known->second;
}

int GltfWriter::addMesh(const std::string& name, const ShadedMesh& shaded, int material) {
    Numbers vertices, normals;
    for (const Vec3& vertex : shaded.vertices)
        append(vertices, vertex);
    for (const Vec3& normal : shaded.normals)
        append(normals, normal);
    std::vector<std::uint32_t> indices;
    for (const Triangle& t : shaded.triangles)
        indices.insert(indices.end(), t.begin(), t.end());

    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = material;
    primitive.attributes["POSITION"] = addVertices(vertices);
    primitive.attributes["NORMAL"] = addVertices(normals);
    primitive.indices = m_buffer.addIndices(indices);
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(primitive);
    m_model.meshes.push_back(mesh);
    return int(m_model.meshes.size()) - 1;
}

/// Bodies of one shape and look share the mesh, whether or not they share the hull.
int GltfWriter::meshOf(const FilmedBody& body) {
    const TriangleMesh triangles = trianglesOf(*body.hull);
    Numbers vertices;
    for (const Vec3& vertex : triangles.vertices)
        append(vertices, vertex);
    const auto [known, isNew] = m_meshes.try_emplace({body.look, vertices}, 0);
    if (isNew) known->second = addMesh(body.name, shade(triangles), materialOfLook(body.look));
    return known->second;
}

int GltfWriter::addNode(const std::string& name, int mesh) {
    tinygltf::Node node;
    node.name = name;
    node.mesh = mesh;
    m_model.nodes.push_back(node);
    m_model.scenes.front().nodes.push_back(int(m_model.nodes.size()) - 1);
    return m_model.scenes.front().nodes.back();
}

/// A key for each frame.
void GltfWriter::addChannel(int node, const char* path, const Numbers& keys, int type, bool steps) {
    tinygltf::AnimationSampler sampler;
    sampler.input = m_times;
    sampler.output = m_buffer.addFloats(keys, type);
    sampler.interpolation = steps || m_film.def().slides ? "STEP" : "LINEAR";
    m_animation.samplers.push_back(sampler);
    tinygltf::AnimationChannel channel;
    channel.sampler = int(m_animation.samplers.size()) - 1;
    channel.target_node = node;
    channel.target_path = path;
    m_animation.channels.push_back(channel);
}

/// Where it is not seen a body has no size.
void GltfWriter::addPresence(int node, const FilmedBody& body) {
    Numbers scales;
    bool comesOrGoes = false;
    for (std::size_t i = 0; i < m_film.times().size(); ++i) {
        const bool isThere = i >= body.firstFrame && i - body.firstFrame < body.poses.size() &&
                             m_film.isOnStage(body, body.poses[i - body.firstFrame]);
        append(scales, Vec3::Constant(isThere ? 1 : 0));
        comesOrGoes = comesOrGoes || !isThere;
    }
    if (comesOrGoes) addChannel(node, "scale", scales, TINYGLTF_TYPE_VEC3, true);
}

/// What its values are in frame `i`, where it is seen, and the nearest of them elsewhere.
template <typename Value>
const Value& valueIn(const FilmedBody& body, const std::vector<Value>& values, std::size_t i) {
    return values[std::min(std::max(i, body.firstFrame) - body.firstFrame, values.size() - 1)];
}

void GltfWriter::addBody(const FilmedBody& body) {
    const int node = addNode(body.name, meshOf(body));
    Numbers places, turns;
    bool moves = false;
    for (std::size_t i = 0; i < m_film.times().size(); ++i) {
        const Pose& pose = valueIn(body, body.poses, i);
        append(places, pose.position);
        append(turns, pose.orientation);
        moves = moves || pose.position != body.poses.front().position ||
                pose.orientation.coeffs() != body.poses.front().orientation.coeffs();
    }
    m_model.nodes[std::size_t(node)].translation.assign(places.begin(), places.begin() + 3);
    m_model.nodes[std::size_t(node)].rotation.assign(turns.begin(), turns.begin() + 4);
    addPresence(node, body);
    if (!moves) return;
    addChannel(node, "translation", places, TINYGLTF_TYPE_VEC3);
    addChannel(node, "rotation", turns, TINYGLTF_TYPE_VEC4);
}

/// A ball at the centre of buoyancy, and from there an arrow as long as the body for the whole hull's
/// displacement.
void GltfWriter::addForce(const FilmedBody& body) {
    if (m_arrowMesh < 0) {
        const int material = addMaterial(gltfMaterial("force", {0.0, 0.7, 0.8}, 1, 0.5, 0));
        const Hull ball = *makeHull({Sphere{Vec3::Zero(), 1}}).hull;
        const Hull arrow = *makeHull({makeCylinder({0, 0.4, 0}, Vec3::UnitY(), 0.02, 0.4),
                                      makeCone({0, 0.8, 0}, Vec3::UnitY(), 0.05, 0.2)})
                                .hull;
        m_centreMesh = addMesh("centre of buoyancy", shade(trianglesOf(ball)), material);
        m_arrowMesh = addMesh("force", shade(trianglesOf(arrow)), material);
    }
    const double radius = body.hull->bounds.radius;
    Numbers places, ballSizes, arrowSizes, turns;
    for (std::size_t i = 0; i < m_film.times().size(); ++i) {
        const WaterForce& force = valueIn(body, body.forces, i);
        const double share = force.force.norm();
        append(places, force.centre);
        append(ballSizes, Vec3::Constant(share > 0 ? 0.04 * radius : 0));
        append(arrowSizes, Vec3::Constant(2 * radius * share));
        append(turns, turnOfArrow(share > 0 ? force.force : Vec3(Vec3::UnitY())));
    }
    const int ball = addNode(body.name + ": centre of buoyancy", m_centreMesh),
              arrow = addNode(body.name + ": force", m_arrowMesh);
    for (int node : {ball, arrow})
        addChannel(node, "translation", places, TINYGLTF_TYPE_VEC3);
    addChannel(ball, "scale", ballSizes, TINYGLTF_TYPE_VEC3, true);
    addChannel(arrow, "scale", arrowSizes, TINYGLTF_TYPE_VEC3);
    addChannel(arrow, "rotation", turns, TINYGLTF_TYPE_VEC4);
}

void GltfWriter::addFlatWater(int material, const FilmedSurface& surface) {
    constexpr int last = Film::waterNodes - 1;
    ShadedMesh quad;
    for (int node : {0, last, last * Film::waterNodes + last, last * Film::waterNodes}) {
        quad.vertices.push_back(waterVertex(m_film, surface, node));
        quad.normals.push_back(Vec3::UnitY());
    }
    quad.triangles = {{0, 1, 2}, {0, 2, 3}};
    addNode("water", addMesh("water", quad, material));
}

void GltfWriter::addWaves(int material) {
    const WaterModes modes = findWaterModes(m_film.surfaces(), waterTolerance);
    constexpr int nodes = Film::waterNodes * Film::waterNodes;
    ShadedMesh rest;
    rest.triangles = waterTriangles();
    // Normals must be of unit length at rest, which leaves their sums the directions that they have.
    std::vector<double> shares;
    for (int i = 0; i < nodes; ++i) {
        rest.vertices.push_back(waterVertex(m_film, modes.rest, i));
        const Vec3 normal = waterNormal(modes.rest, i);
        shares.push_back(1 / normal.norm());
        rest.normals.push_back(shares.back() * normal);
    }
    const int mesh = addMesh("water", rest, material);
    for (const FilmedSurface& mode : modes.modes) {
        Numbers rises, turns;
        for (int i = 0; i < nodes; ++i) {
            append(rises, double(mode(i, 0)) * Vec3::UnitY());
            append(turns, shares[std::size_t(i)] * (waterNormal(mode, i) - Vec3::UnitY()));
        }
        const int risesAccessor = addVertices(rises), turnsAccessor = addVertices(turns);
        m_model.meshes[std::size_t(mesh)].primitives.front().targets.push_back(
            {{"POSITION", risesAccessor}, {"NORMAL", turnsAccessor}});
    }
    // A player that does not play shows the first frame.
    for (Eigen::Index i = 0; i < modes.weights.cols(); ++i)
        m_model.meshes[std::size_t(mesh)].weights.push_back(double(modes.weights(0, i)));
    Numbers weights;
    for (Eigen::Index frame = 0; frame < modes.weights.rows(); ++frame)
        for (Eigen::Index i = 0; i < modes.weights.cols(); ++i)
            weights.push_back(modes.weights(frame, i));
    const int node = addNode("water", mesh);
    if (!weights.empty()) addChannel(node, "weights", weights, TINYGLTF_TYPE_SCALAR);
}

void GltfWriter::addWater() {
    const std::vector<FilmedSurface>& surfaces = m_film.surfaces();
    if (surfaces.empty()) return;
    tinygltf::Material water = gltfMaterial("water", {0.02, 0.16, 0.22}, 0.6, 0.15, 0);
    water.alphaMode = "BLEND";
    water.doubleSided = true;
    const int material = addMaterial(water);
    bool still = isFlat(surfaces.front());
    for (const FilmedSurface& surface : surfaces)
        still = still && (surface.col(0) == surfaces.front().col(0)).all();
    if (still)
        addFlatWater(material, surfaces.front());
    else
        addWaves(material);
}

tinygltf::Model GltfWriter::write() {
    m_model.asset.version = "2.0";
    m_model.asset.generator = "bullet_buoyancy " BULLET_BUOYANCY_VERSION;
    m_model.scenes.emplace_back();
    m_model.defaultScene = 0;
    Numbers times;
    for (double time : m_film.times())
        times.push_back(float(time - m_film.times().front()));
    m_times = m_buffer.addFloats(times, TINYGLTF_TYPE_SCALAR);
    m_animation.name = "motion";
    for (const FilmedBody& body : m_film.bodies()) {
        if (body.poses.empty()) continue;
        addBody(body);
        if (m_film.def().forces) addForce(body);
    }
    addWater();  // last, since it is transparent
    if (!m_animation.channels.empty()) m_model.animations.push_back(m_animation);
    return std::move(m_model);
}

}  // namespace

std::string writeGltf(const Film& film, const std::string& file) {
    if (film.times().empty()) return "there is nothing to see";
    const tinygltf::Model model = GltfWriter(film).write();
    const std::string part = file + ".part";
    constexpr bool embedImages = true, embedBuffers = true, indented = false, binary = true;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToFile(&model, part, embedImages, embedBuffers, indented, binary))
        return "cannot write " + part;
    std::error_code error;
    std::filesystem::rename(part, file, error);
    return error ? "cannot write " + file + ": " + error.message() : "";
}

}  // namespace bullet_buoyancy::recording
