// What the programs that measure a peer have in common: reading a room, measuring ticks, and printing what rays hit.
// src/conf/compare-peers builds and runs them.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace comparison {

// Metres and radians, in all of these.
struct Point {
    double x, y;
};

struct Pose {
    double x, y, heading;
};

// A room as PeerComparison writes it. Polygons are convex, counter-clockwise and inside the enclosing wall.
struct Room {
    double side, length, width, track, left, right, range, cone;
    Pose start;
    std::vector<Pose> sensors;  // in the robot's frame
    std::vector<std::vector<Point>> polygons;
    std::vector<Pose> poses;  // where nothing is near the robot
};

inline Room read(const std::string &path) {
    Room room{};
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream text(line);
        std::string word;
        text >> word;
        Pose pose;
        if (word == "side") {
            text >> room.side;
        } else if (word == "robot") {
            text >> room.length >> room.width >> room.track;
        } else if (word == "wheels") {
            text >> room.left >> room.right;
        } else if (word == "cone") {
            text >> room.range >> room.cone;
        } else if (word == "start") {
            text >> room.start.x >> room.start.y >> room.start.heading;
        } else if (word == "sensor" && text >> pose.x >> pose.y >> pose.heading) {
            room.sensors.push_back(pose);
        } else if (word == "pose" && text >> pose.x >> pose.y >> pose.heading) {
            room.poses.push_back(pose);
        } else if (word == "polygon") {
            std::vector<Point> polygon;
            for (Point corner; text >> corner.x >> corner.y;) {
                polygon.push_back(corner);
            }
            room.polygons.push_back(polygon);
        }
    }
    if (room.sensors.empty()) {
        std::fprintf(stderr, "%s is not a room\n", path.c_str());
        std::exit(2);
    }
    return room;
}

// The same room in a peer, with a robot that drives a circle.
class Peer {
public:
    virtual ~Peer() = default;
    virtual void tick() = 0;
    // Puts the robot somewhere and makes a tick there, after one in which it stops.
    virtual void stand(const Pose &pose) = 0;
    // What each ray of each sensor hits, from right to left: the distance, or the range if it hits nothing.
    virtual std::vector<double> rays() const = 0;
    virtual Point position() const = 0;
};

// The processor time of the process, with all its threads, seconds.
inline double now() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time.tv_sec + time.tv_nsec * 1e-9;
}

// Returns the time of a tick, microseconds. The number of ticks is doubled until they take long enough, so that all
// but the last ones only warm up.
inline double tickTime(Peer &peer, double seconds) {
    for (long ticks = 1;; ticks *= 2) {
        const double begin = now();
        for (long i = 0; i < ticks; i++) {
            peer.tick();
        }
        const double time = now() - begin;
        if (time >= seconds) {
            return time / ticks * 1e6;
        }
    }
}

// Ends the process if the robot is not on its circle round the middle of the room, for example after a collision.
inline void checkCircle(const Peer &peer, const Room &room) {
    constexpr double TOLERANCE = 0.02;
    const double middle = room.side / 2;
    const Point at = peer.position();
    const double radius = std::hypot(at.x - middle, at.y - middle);
    if (std::abs(radius - std::hypot(room.start.x - middle, room.start.y - middle)) > TOLERANCE) {
        std::fprintf(stderr, "the robot left its circle: it is %.3f m from the middle of the room\n", radius);
        std::exit(1);
    }
}

// VARIANT times SECONDS ROOM... prints a line "time MICROSECONDS" for each room; VARIANT readings ROOM prints a line
// "rays DISTANCE..." for each pose. A peer may print other lines.
inline int main(int count, char **words, const std::function<std::unique_ptr<Peer>(const Room &, std::string)> &make) {
    const std::string variant = words[1];
    const bool times = words[2] == std::string("times");
    for (int i = times ? 4 : 3; i < count; i++) {
        const Room room = read(words[i]);
        const std::unique_ptr<Peer> peer = make(room, variant);
        if (times) {
            std::printf("time %.6f\n", tickTime(*peer, std::atof(words[3])));
            checkCircle(*peer, room);
            continue;
        }
        for (const Pose &pose : room.poses) {
            peer->stand(pose);
            std::printf("rays");
            for (const double ray : peer->rays()) {
                std::printf(" %.9f", ray);
            }
            std::printf("\n");
        }
    }
    return 0;
}

}  // namespace comparison
