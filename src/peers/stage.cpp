// The room in Stage, https://github.com/rtv/Stage, without its window, with one ranger of all sensors.
// The variant is the number of rays of a sensor.
#include "comparison.h"

#include "stage.hh"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace {

using comparison::Pose;
using comparison::Room;

double degrees(double radians) {
    return radians * 180 / M_PI;
}

// A solid of this outline; Stage scales it to the size and centres it at the pose.
void writeSolid(std::ostream &text, const std::vector<comparison::Point> &corners) {
    auto x = std::minmax_element(corners.begin(), corners.end(), [](auto a, auto b) { return a.x < b.x; });
    auto y = std::minmax_element(corners.begin(), corners.end(), [](auto a, auto b) { return a.y < b.y; });
    text << "model ( pose [" << (x.first->x + x.second->x) / 2 << ' ' << (y.first->y + y.second->y) / 2 << " 0 0] size ["
         << x.second->x - x.first->x << ' ' << y.second->y - y.first->y << " 1] block ( points " << corners.size();
    for (size_t i = 0; i < corners.size(); i++) {
        text << " point[" << i << "] [" << corners[i].x << ' ' << corners[i].y << ']';
    }
    text << " z [0 1] ) )\n";
}

void writeBox(std::ostream &text, double left, double low, double right, double high) {
    writeSolid(text, {{left, low}, {right, low}, {right, high}, {left, high}});
}

// The room in Stage's format, at Stage's default resolution of 2 cm. Its models are updated in each tick of 10 ms.
std::string worldFile(const Room &room, int samples) {
    constexpr double THICK = 0.1;
    std::ostringstream text;
    text << std::fixed;  // Stage reads no exponents
    text.precision(9);
    text << "interval_sim 10\n";
    const double end = room.side + THICK;
    writeBox(text, -THICK, -THICK, end, 0);
    writeBox(text, -THICK, room.side, end, end);
    writeBox(text, -THICK, 0, 0, room.side);
    writeBox(text, room.side, 0, end, room.side);
    for (const auto &polygon : room.polygons) {
        writeSolid(text, polygon);
    }
    text << "position ( name \"robot\" update_interval 10 drive \"diff\" localization \"gps\" pose [" << room.start.x << ' '
         << room.start.y << " 0 " << degrees(room.start.heading) << "] size [" << room.length << ' ' << room.width
         << " 0.2]\n  ranger ( name \"eyes\" update_interval 10 pose [0 0 0 0]\n";
    for (const Pose &at : room.sensors) {
        text << "    sensor ( pose [" << at.x << ' ' << at.y << " 0 " << degrees(at.heading) << "] range [0 " << room.range
             << "] fov " << degrees(room.cone) << " samples " << samples << " )\n";
    }
    text << "  )\n)\n";
    return text.str();
}

class StageRoom : public comparison::Peer {
public:
    // Stage's threads use a world until the process ends, so it is never deleted.
    StageRoom(const Room &room, int samples) : world(*new Stg::World) {
        std::istringstream text(worldFile(room, samples));
        world.Load(text, "");
        robot = dynamic_cast<Stg::ModelPosition *>(world.GetModel("robot"));
        eyes = dynamic_cast<Stg::ModelRanger *>(world.GetModel("robot.eyes"));
        if (robot == nullptr || eyes == nullptr || eyes->GetSensors().size() != room.sensors.size()) {
            std::fprintf(stderr, "Stage did not make the robot\n");
            std::exit(1);
        }
        // A first tick that comes before Stage's thread waits for it would never end.
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        robot->Subscribe();
        eyes->Subscribe();
        robot->SetSpeed((room.left + room.right) / 2, 0, (room.right - room.left) / room.track);
    }

    void tick() override { world.Update(); }

    void stand(const Pose &pose) override {
        robot->Stop();
        tick();  // a command acts from the next tick on
        robot->SetPose(Stg::Pose(pose.x, pose.y, 0, pose.heading));
        tick();
    }

    std::vector<double> rays() const override {
        std::vector<double> rays;
        for (const auto &sensor : eyes->GetSensors()) {
            rays.insert(rays.end(), sensor.ranges.begin(), sensor.ranges.end());
        }
        return rays;
    }

    comparison::Point position() const override {
        const Stg::Pose pose = robot->GetGlobalPose();
        return {pose.x, pose.y};
    }

private:
    Stg::World &world;
    Stg::ModelPosition *robot;
    Stg::ModelRanger *eyes;
};

}  // namespace

int main(int count, char **words) {
    Stg::Init(&count, &words);
    return comparison::main(count, words, [](const Room &room, const std::string &variant) {
        return std::unique_ptr<comparison::Peer>(new StageRoom(room, std::stoi(variant)));
    });
}
