"""A first wall follower: searches for a wall, and keeps it on its left at 0.25 m."""

import faultline

beside_wall = False


def decide(sight):
    global beside_wall
    ahead = min(sight.distance("front", otherwise=9), sight.distance("front-left", otherwise=9) + 0.05)
    if ahead < 0.30:
        beside_wall = True
        return faultline.velocities(0.0, -1.0, state="TURN", why="wall ahead")
    if not beside_wall:
        return faultline.velocities(0.3, 0.0, state="SEARCH")
    error = sight.distance("left", otherwise=0.45) - 0.25
    return faultline.velocities(0.2, max(-1.0, min(0.7, 5.0 * error)), state="FOLLOW", why="beside a wall")


faultline.drive_with(decide, name="my follower")
