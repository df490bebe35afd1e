// The room in Enki, https://github.com/enki-community/enki, with its generic infrared sensor, which has three rays.
// Variants: "apart" makes an object of each polygon, "together" one object of all.
#include "comparison.h"

#include <enki/PhysicalEngine.h>
#include <enki/interactions/IRSensor.h>
#include <enki/robots/DifferentialWheeled.h>

namespace {

using comparison::Pose;
using comparison::Room;

constexpr double CM = 100;  // Enki's unit of length
constexpr double DT = 0.01;
constexpr double HEIGHT = 10;
constexpr double FIXED = -1;  // the mass of an object that nothing moves

class Robot : public Enki::DifferentialWheeled {
public:
    explicit Robot(const Room &room) : DifferentialWheeled(room.track * CM, 100, 0) {
        setRectangular(room.length * CM, room.width * CM, HEIGHT, 1);
        for (const Pose &at : room.sensors) {
            const Enki::Vector mount(at.x * CM, at.y * CM);
            // Any response function does: only the distances of the rays are compared.
            eyes.emplace_back(new Enki::IRSensor(this, mount, HEIGHT / 2, at.heading, room.range * CM, 1, 0, 100));
            addLocalInteraction(eyes.back().get());
        }
    }

    std::vector<std::unique_ptr<Enki::IRSensor>> eyes;
};

Enki::PhysicalObject *object(const Enki::PhysicalObject::Hull &hull) {
    auto *object = new Enki::PhysicalObject;
    object->setCustomHull(hull, FIXED);  // also moves the object to its centre of mass
    return object;
}

class EnkiRoom : public comparison::Peer {
public:
    EnkiRoom(const Room &room, bool together) : world(room.side * CM, room.side * CM), robot(new Robot(room)) {
        Enki::PhysicalObject::Hull all;
        for (const auto &corners : room.polygons) {
            Enki::Polygon polygon;
            for (const comparison::Point &corner : corners) {
                polygon.push_back(Enki::Point(corner.x * CM, corner.y * CM));
            }
            const Enki::PhysicalObject::Hull one(Enki::PhysicalObject::Part(polygon, HEIGHT));
            if (together) {
                all += one;
            } else {
                world.addObject(object(one));
            }
        }
        if (!all.empty()) {
            world.addObject(object(all));
        }
        world.addObject(robot);  // the world deletes it
        place(room.start);
        robot->leftSpeed = room.left * CM;
        robot->rightSpeed = room.right * CM;
    }

    void tick() override { world.step(DT); }

    void stand(const Pose &pose) override {
        robot->leftSpeed = robot->rightSpeed = 0;
        tick();  // a command acts from the next tick on
        place(pose);
        tick();
    }

    std::vector<double> rays() const override {
        std::vector<double> rays;
        for (const auto &eye : robot->eyes) {
            for (unsigned i = 0; i < eye->getRayCount(); i++) {
                rays.push_back(eye->getRayDist(i) / CM);
            }
        }
        return rays;
    }

    comparison::Point position() const override { return {robot->pos.x / CM, robot->pos.y / CM}; }

private:
    void place(const Pose &pose) {
        robot->pos = Enki::Point(pose.x * CM, pose.y * CM);
        robot->angle = pose.heading;
    }

    Enki::World world;
    Robot *robot;
};

}  // namespace

int main(int count, char **words) {
    return comparison::main(count, words, [](const Room &room, const std::string &variant) {
        return std::unique_ptr<comparison::Peer>(new EnkiRoom(room, variant == "together"));
    });
}
