package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The clearance uses only the segments near the robot; the reference implementation uses all segments. */
class ClearanceTest {

    private static ObstacleShape shape(Random random) {
        List<List<Vector2>> rings = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            List<Vector2> ring = new ArrayList<>();
            for (int k = 0; k < 3 + random.nextInt(6); k++) {
                ring.add(new Vector2(3 * random.nextDouble(), 3 * random.nextDouble()));
            }
            rings.add(ring);
        }
        return switch (random.nextInt(3)) {
            case 0 -> new ObstacleShape.PlanShape(rings);
            case 1 -> new ObstacleShape.PolygonShape(rings.get(0));
            default -> new ObstacleShape.WallShape(rings.get(0));
        };
    }

    @Test
    void thereIsRoomOnlyWithinAnEnclosedWorld() {
        RobotSpec robot = RobotSpec.DEFAULT;
        WorldSpec open = new WorldSpec(8, 6, false, 3, List.of());
        WorldSpec enclosed = new WorldSpec(8, 6, true, 3, List.of());
        assertEquals(Optional.empty(), Clearance.findObstruction(enclosed, robot, new Pose(1, 1, 0)));
        for (Pose outside : List.of(new Pose(20, 1, 0), new Pose(-1, 1, 0), new Pose(1, 9, 0), new Pose(1, -9, 0))) {
            assertEquals(Optional.of(WorldSpec.ENCLOSURE), Clearance.findObstruction(enclosed, robot, outside));
            assertEquals(Optional.empty(), Clearance.findObstruction(open, robot, outside));
        }
    }

    @Test
    void theSegmentsNearTheRobotDecideAsAllSegmentsDo() {
        Random random = new Random(2206);
        RobotSpec robot = RobotSpec.DEFAULT;
        int clear = 0;
        for (int i = 0; i < 2000; i++) {
            Pose frame = new Pose(2 + random.nextDouble(), 2 + random.nextDouble(), 6.3 * random.nextDouble());
            Obstacle obstacle = new Obstacle("o", shape(random), frame);
            WorldSpec world = new WorldSpec(8, 8, false, 3, List.of(obstacle));
            Pose pose = new Pose(1 + 4 * random.nextDouble(), 1 + 4 * random.nextDouble(), 6.3 * random.nextDouble());
            boolean expected = ObstacleSet.isClear(
                    new OrientedBox(pose, robot.length(), robot.width()), ObstacleGeometry.of(obstacle));
            Optional<String> found = Clearance.findObstruction(world, robot, pose);
            assertEquals(expected, found.isEmpty(), obstacle + " and a robot at " + pose);
            clear += expected ? 1 : 0;
        }
        assertTrue(clear > 200 && clear < 1900, clear + " of 2000 were clear");
    }
}
