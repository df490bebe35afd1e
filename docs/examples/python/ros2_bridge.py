"""Connects a run to ROS 2: publishes each sensor as sensor_msgs/Range and drives as geometry_msgs/Twist says.

With the environment of ROS 2 and a node that answers every set of ranges by one command:

    faultline run FILE --controller "python3 ros2_bridge.py" --patience none

The two are in lock-step: a tick waits for its command, and the sensors are published in their order, so the node should
answer after the last sensor that it uses.
"""

import math
import re

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import Range

import faultline


class Bridge(Node):
    """Topics range/SENSOR, as ``to_topic`` names them, and cmd_vel."""

    def __init__(self, robot):
        super().__init__("faultline")
        self._command = None
        self._outputs = {
            sensor["id"]: self.create_publisher(Range, to_topic(sensor["id"]), 10)
            for sensor in robot["sensors"]
        }
        self.create_subscription(Twist, "cmd_vel", self._receive, 10)

    def wait_for_node(self):
        """Waits until a node sends commands and receives ranges; what is published before that is lost."""
        while self.count_publishers("cmd_vel") == 0 or not any(
            output.get_subscription_count() for output in self._outputs.values()
        ):
            rclpy.spin_once(self, timeout_sec=0.1)

    def decide(self, sight):
        self._command = None
        for sensor in sight.robot["sensors"]:
            self._outputs[sensor["id"]].publish(to_range(sensor, sight[sensor["id"]], sight.t))
        while self._command is None:
            rclpy.spin_once(self)
        return faultline.velocities(self._command.linear.x, self._command.angular.z, state="ROS")

    def _receive(self, command):
        self._command = command


def to_topic(sensor):
    """Returns the topic of a sensor: ROS 2 allows letters, digits and underscores, and no digit at the beginning."""
    name = re.sub("[^A-Za-z0-9_]", "_", sensor)
    return "range/" + ("_" if name[0].isdigit() else "") + name


def to_range(sensor, reading, t):
    """Returns a reading as a message, with the values of REP 117 for what is no distance."""
    message = Range()
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(round(t * 1e9), 10**9)
    message.header.frame_id = sensor["id"]
    message.radiation_type = Range.INFRARED
    message.field_of_view = float(sensor["cone_rad"])
    message.min_range = 0.0
    message.max_range = float(sensor["range_m"])
    if reading is faultline.NO_ANSWER:
        message.range = math.nan
    else:
        message.range = math.inf if reading is None else float(reading)
    return message


def main():
    rclpy.init()
    bridges = []

    def begin(hello):
        bridges.append(Bridge(hello["robot"]))
        bridges[0].wait_for_node()

    faultline.drive_with(lambda sight: bridges[0].decide(sight), name="ROS 2", begin=begin)
    rclpy.shutdown()


if __name__ == "__main__":
    main()
