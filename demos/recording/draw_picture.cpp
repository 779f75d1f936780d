#include "recording/draw_picture.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "bullet_buoyancy/core/constants.h"
#include "recording/camera.h"
#include "recording/shaded_mesh.h"
#include "recording/water_mesh.h"

namespace bullet_buoyancy::recording {

namespace {

constexpr int width = 1200, height = 675;  // pixels
constexpr double azimuth = 0.55, elevation = 0.38;

std::string text(const Vec3& v) {
    std::ostringstream out;
    out << '<' << v.x() << ',' << v.y() << ',' << v.z() << '>';
    return out.str();
}

void writeMesh(std::ostream& out, const ShadedMesh& mesh) {
    out << "mesh2{vertex_vectors{" << mesh.vertices.size();
    for (const Vec3& vertex : mesh.vertices)
        out << ',' << text(vertex);
    out << "}normal_vectors{" << mesh.normals.size();
    for (const Vec3& normal : mesh.normals)
        out << ',' << text(normal);
    out << "}face_indices{" << mesh.triangles.size();
    for (const Triangle& t : mesh.triangles)
        out << ",<" << t[0] << ',' << t[1] << ',' << t[2] << '>';
    out << '}';
}

bool isWood(Look look) {
    return look == Look::wood || look == Look::paleWood || look == Look::darkWood;
}

/// Wood has a grain along the body's x.
void writeTexture(std::ostream& out, Look look) {
    const Material& material = materialOf(look);
    if (isWood(look))
        out << "texture{pigment{wood turbulence 0.04 omega 0.4 color_map{[0 rgb" << text(material.colour)
            << "][1 rgb" << text(0.55 * material.colour) << "]} scale 0.12 rotate 90*y rotate 4*z}";
    else
        out << "texture{pigment{rgb" << text(material.colour) << '}';
    out << "finish{ambient 0 diffuse 0.75 specular " << 0.5 * (1 - material.roughness) << " roughness 0.02"
        << (material.metallic > 0 ? " metallic reflection{0.25 metallic}" : "") << "}}";
}

void writeBody(std::ostream& out, const FilmedBody& body, const Pose& pose) {
    writeMesh(out, shade(trianglesOf(*body.hull)));
    writeTexture(out, body.look);
    const Mat3 turn = pose.worldFromBody();
    out << "matrix<";
    for (int column = 0; column < 3; ++column)
        out << turn(0, column) << ',' << turn(1, column) << ',' << turn(2, column) << ',';
    out << pose.position.x() << ',' << pose.position.y() << ',' << pose.position.z() << ">}\n";
}

/// A block of the sea, whose top is the surface.
struct Block {
    ShadedMesh mesh;
    std::vector<Vec3> corners;  ///< on top and below
};

/// A wall below one edge of the surface, from node to node in the order in which they are seen from outside,
/// from left to right.
void addWall(ShadedMesh& mesh, const std::vector<Vec3>& top, double bottom) {
    const Vec3 normal = Vec3::UnitY().cross(top.front() - top.back()).normalized();
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const Vec3& vertex : top)
        for (double y : {vertex.y(), bottom}) {
            mesh.vertices.emplace_back(vertex.x(), y, vertex.z());
            mesh.normals.push_back(normal);
        }
    for (std::uint32_t i = 0; i + 1 < top.size(); ++i) {
        const std::uint32_t a = first + 2 * i;
        mesh.triangles.push_back({a, a + 1, a + 3});
        mesh.triangles.push_back({a, a + 3, a + 2});
    }
}

Block cutBlock(const Film& film, const FilmedSurface& surface, double bottom) {
    constexpr int nodes = Film::waterNodes, last = nodes - 1;
    Block block;
    block.mesh.triangles = waterTriangles();
    for (int i = 0; i < nodes * nodes; ++i) {
        block.mesh.vertices.push_back(waterVertex(film, surface, i));
        block.mesh.normals.push_back(waterNormal(surface, i).normalized());
    }
    const std::vector<Vec3> top(block.mesh.vertices);
    std::vector<Vec3> walls[4];
    for (int i = 0; i < nodes; ++i) {
        walls[0].push_back(top[std::size_t(i)]);                        // near
        walls[1].push_back(top[std::size_t(i * nodes + last)]);         // right
        walls[2].push_back(top[std::size_t(last * nodes + last - i)]);  // far
        walls[3].push_back(top[std::size_t((last - i) * nodes)]);       // left
    }
    for (const std::vector<Vec3>& wall : walls) {
        addWall(block.mesh, wall, bottom);
        for (double y : {wall.front().y(), bottom})
            block.corners.emplace_back(wall.front().x(), y, wall.front().z());
    }
    std::vector<Vec3> floor;
    const auto first = std::uint32_t(block.mesh.vertices.size());
    for (const std::vector<Vec3>& wall : walls) {
        block.mesh.vertices.emplace_back(wall.front().x(), bottom, wall.front().z());
        block.mesh.normals.push_back(-Vec3::UnitY());
    }
    block.mesh.triangles.push_back({first, first + 2, first + 1});
    block.mesh.triangles.push_back({first, first + 3, first + 2});
    return block;
}

/// Of what is to be in the picture.
struct Extent {
    double size = 0;     ///< of the stage, or of the bodies, m
    double deepest = 0;  ///< y, m
    std::vector<Vec3> points;
};

/// Null where the body is not seen.
const Pose* poseIn(const Film& film, const FilmedBody& body, std::size_t frame) {
    if (frame < body.firstFrame || frame - body.firstFrame >= body.poses.size()) return nullptr;
    const Pose& pose = body.poses[frame - body.firstFrame];
    return film.isOnStage(body, pose) ? &pose : nullptr;
}

Extent extentOf(const Film& film, std::size_t frame) {
    Extent extent;
    const double stage = film.stage().reach.norm();
    for (const FilmedBody& body : film.bodies()) {
        const Pose* pose = poseIn(film, body, frame);
        if (!pose || (stage > 0 && body.hull->bounds.radius > stage)) continue;
        const Vec3 centre = pose->position + pose->orientation * body.hull->bounds.centre;
        const Vec3 half = pose->worldFromBody().cwiseAbs() * body.hull->halfExtents;
        extent.deepest = std::min(extent.deepest, centre.y() - half.y());
        extent.size = std::max(extent.size, half.norm());
        for (int corner = 0; corner < 8; ++corner)
            extent.points.push_back(centre + half.cwiseProduct(Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                                                    corner & 4 ? 1 : -1)));
    }
    if (stage > 0) extent.size = stage;
    return extent;
}

void writeLights(std::ostream& out, const Camera& camera, double size) {
    const Vec3 sun = camera.target + 20 * size * Vec3(-0.5, 1, 0.55);
    out << "light_source{" << text(sun) << " rgb<1.5,1.42,1.3> area_light " << 3 * size << "*x " << 3 * size
        << "*z 6 6 adaptive 1 jitter circular orient}\n"
        << "light_source{" << text(camera.position + size * Vec3::UnitY())
        << " rgb<0.28,0.32,0.38> shadowless}\n"
        << "light_source{" << text(camera.target + 20 * size * Vec3(0.8, 0.5, -0.6))
        << " rgb<0.25,0.28,0.32> shadowless}\n";
}

void writeSetting(std::ostream& out, const Camera& camera, double size) {
    out << "#version 3.7;\nglobal_settings{assumed_gamma 1.0 max_trace_level 12}\n"
        << "camera{location" << text(camera.position) << " up y right -x*image_width/image_height angle "
        << 2 * std::atan(camera.tangent) * 180 / pi << " look_at" << text(camera.target) << "}\n"
        << "background{rgb 0.92}\n"
        << "sky_sphere{pigment{gradient y color_map{[0 rgb<0.86,0.9,0.94>][1 rgb<0.55,0.7,0.88>]}}}\n";
    writeLights(out, camera, size);
}

/// Without refraction, so that what is below the surface stands where it is.
void writeWater(std::ostream& out, const Block& block, double depth) {
    writeMesh(out, block.mesh);
    out << "texture{pigment{rgbf<0.32,0.66,0.76,0.72>}finish{ambient 0 diffuse 0.22 specular 0.6 roughness "
           "0.003 reflection{0.05,0.5 falloff 3}}}interior{ior 1 fade_distance "
        << 2 * depth << " fade_power 1001 fade_color<0.1,0.5,0.6>} no_shadow}\n";
}

std::string sceneOf(const Film& film, std::size_t frame) {
    Extent extent = extentOf(film, frame);
    std::ostringstream objects;
    for (const FilmedBody& body : film.bodies())
        if (const Pose* pose = poseIn(film, body, frame)) writeBody(objects, body, *pose);
    if (!film.surfaces().empty()) {
        const double depth = std::max(0.2 * extent.size, -1.15 * extent.deepest);
        const Block block = cutBlock(film, film.surfaces()[frame], -depth);
        extent.points.insert(extent.points.end(), block.corners.begin(), block.corners.end());
        writeWater(objects, block, depth);
    }
    std::ostringstream scene;
    writeSetting(scene, aimCamera(extent.points, azimuth, elevation, double(width) / height), extent.size);
    return scene.str() + objects.str();
}

#ifdef _WIN32
const char* const quiet = " > NUL 2>&1";
#else
const char* const quiet = " > /dev/null 2>&1";
#endif

bool isInstalled() {
    return std::system((std::string("povray --version") + quiet).c_str()) == 0;
}

/// In a directory of its own, since POV-Ray writes where it is run only, and no name needs quoting.
bool render(const std::string& scene, const std::filesystem::path& directory) {
    std::ofstream script(directory / "scene.pov");
    script << scene;
    if (!script.flush()) return false;
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(directory);
    const std::string command = "povray +Iscene.pov +Opicture.png +W" + std::to_string(width) + " +H" +
                                std::to_string(height) + " +A0.1 +AM2 +R3 -D" + quiet;
    const int status = std::system(command.c_str());
    std::filesystem::current_path(here);
    return status == 0;
}

}  // namespace

std::string drawPicture(const Film& film, std::size_t frame, const std::string& file) {
    if (!isInstalled()) return "no picture, since povray is not installed (Debian: povray)";
    std::error_code error;
    const std::filesystem::path directory = file + ".parts";
    std::filesystem::create_directory(directory, error);
    if (error) return "cannot write " + file + ": " + error.message();
    const bool drawn = render(sceneOf(film, frame), directory);
    if (drawn) std::filesystem::rename(directory / "picture.png", file, error);
    std::error_code ignored;
    std::filesystem::remove_all(directory, ignored);
    if (!drawn) return "povray could not draw " + file;
    return error ? "cannot write " + file + ": " + error.message() : "";
}

}  // namespace bullet_buoyancy::recording
