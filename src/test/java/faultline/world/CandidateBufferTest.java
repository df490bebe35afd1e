package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The shapes of an obstacle are added all at once as if one by one. */
class CandidateBufferTest {

    private static PlacedObstacle wall(int segments) {
        Vector2[] points = new Vector2[segments + 1];
        for (int i = 0; i <= segments; i++) {
            points[i] = new Vector2(i, i % 2);
        }
        return new PlacedObstacle(
                new Obstacle("wall" + segments, new ObstacleShape.WallShape(List.of(points)), Pose.ORIGIN), 0);
    }

    private static void addOneByOne(PlacedObstacle obstacle, CandidateBuffer buffer) {
        obstacle.parts().forEach(part -> buffer.add(part, obstacle));
    }

    @Test
    void addingAllShapesOfAnObstacleIsAddingOneAfterTheOther() {
        ShapeOwner enclosure = new ShapeOwner(WorldSpec.ENCLOSURE, -1, Obstacle.MATT);
        Segment side = new Segment(0, 0, 9, 0);
        for (int capacity = 1; capacity < 12; capacity++) {
            CandidateBuffer expected = new CandidateBuffer(capacity);
            CandidateBuffer actual = new CandidateBuffer(capacity);
            expected.add(side, enclosure);
            actual.add(side, enclosure);
            for (int segments : new int[] {1, 3, 40, 2}) {
                PlacedObstacle wall = wall(segments);
                addOneByOne(wall, expected);
                actual.addAll(wall);
                assertSameContent(expected, actual);
            }
            expected.add(side, enclosure);
            actual.add(side, enclosure);
            assertSameContent(expected, actual);
        }
    }

    private static void assertSameContent(CandidateBuffer expected, CandidateBuffer actual) {
        assertEquals(expected.size(), actual.size());
        for (int i = 0; i < expected.size(); i++) {
            assertSame(expected.shape(i), actual.shape(i));
            assertSame(expected.owner(i), actual.owner(i));
            assertEquals(expected.number(i), actual.number(i));
        }
    }
}
