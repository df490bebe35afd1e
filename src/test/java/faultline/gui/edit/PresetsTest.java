package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeout;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Presets of sensors and copies of obstacles. */
class PresetsTest {

    private static List<String> on(RobotSpec robot, boolean wallOnLeft, int count) {
        RobotSpec changed = robot;
        for (Command command : SensorPresets.commands(robot, wallOnLeft, count)) {
            Command.SwitchSensor change = (Command.SwitchSensor) command;
            changed = changed.withSensor(
                    changed.sensor(change.sensor()).orElseThrow().withOn(change.on()));
        }
        return changed.sensors().stream()
                .filter(sensor -> sensor.on())
                .map(sensor -> sensor.id())
                .toList();
    }

    @Test
    void copiesStayInTheRoomAndDoNotHideEachOther() {
        Vector2 middle = new Vector2(3, 2);
        assertEquals(new Vector2(0.2, -0.2), ObstacleCopies.offset(middle, 6, 4, List.of(middle)));
        assertEquals(
                new Vector2(-0.2, -0.2), ObstacleCopies.offset(middle, 6, 4, List.of(middle, new Vector2(3.2, 1.8))));
        Vector2 corner = new Vector2(5.9, 0.1);
        assertEquals(new Vector2(-0.2, 0.2), ObstacleCopies.offset(corner, 6, 4, List.of(corner)));
        assertEquals(
                new Vector2(-0.4, 0.4), ObstacleCopies.offset(corner, 6, 4, List.of(corner, new Vector2(5.7, 0.3))));
    }

    @Test
    void aPresetLeavesTheSensorsOnThatWallFollowingNeeds() {
        assertEquals(List.of("front", "left"), on(RobotSpec.DEFAULT, true, 2));
        assertEquals(List.of("front", "left", "front-right"), on(RobotSpec.DEFAULT, true, 3));
        assertEquals(List.of("front", "front-left", "right"), on(RobotSpec.DEFAULT, false, 3));
    }

    @Test
    void thePresetForAllSensorsSwitchesOnlyThoseThatAreOff() {
        RobotSpec one =
                RobotSpec.DEFAULT.withSensor(RobotSpec.DEFAULT.sensors().get(3).withOn(false));
        assertEquals(List.of(new Command.SwitchSensor("rear-left", true)), SensorPresets.commands(one, true, 8));
    }

    @Test
    void copiesAreBesideTheirOriginalsWithTheirMotionPaths() {
        Obstacle visitor = new Obstacle(
                "visitor",
                new ObstacleShape.CircleShape(0.1),
                new Pose(1, 1, 0),
                new WaypointPath(0.2, true, List.of(new Vector2(2, 1))));
        Obstacle copy = ObstacleCopies.copyOf(List.of(visitor), Set.of("visitor"), new Vector2(0.2, -0.2))
                .get(0);
        assertEquals(
                new Obstacle(
                        "visitor-2",
                        visitor.shape(),
                        new Pose(1.2, 0.8, 0),
                        new WaypointPath(0.2, true, List.of(new Vector2(2.2, 0.8)))),
                copy);
    }

    @Test
    void copiesOfSeveralObstaclesHaveDifferentIds() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(1, 1, 0));
        List<Obstacle> copies =
                ObstacleCopies.copyOf(List.of(pole, pole.withId("pole-2")), Set.of("pole"), new Vector2(0.2, -0.2));
        assertEquals(
                List.of("pole-2", "pole-3"), copies.stream().map(Obstacle::id).toList());
        assertEquals(new Pose(1.2, 0.8, 0), copies.get(1).pose());
    }

    @Test
    void manyObstaclesAreCopiedInLinearTime() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(1, 1, 0));
        List<Obstacle> poles = IntStream.rangeClosed(1, 50_000)
                .mapToObj(i -> pole.withId("pole-" + i))
                .toList();
        Set<String> taken = poles.stream().map(Obstacle::id).collect(Collectors.toSet());
        List<Obstacle> copies = assertTimeout(
                Duration.ofSeconds(20), () -> ObstacleCopies.copyOf(poles, taken, new Vector2(0.2, -0.2)));
        assertEquals("pole-50001", copies.get(0).id());
        assertEquals("pole-100000", copies.get(49_999).id());
    }

    @Test
    void aCutObstacleIsPastedAtItsOldPosition() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(1, 1, 0.3));
        assertEquals(List.of(pole), ObstacleCopies.copyOf(List.of(pole), Set.of("desk"), new Vector2(0.2, -0.2)));
    }
}
