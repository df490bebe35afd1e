package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.ConvexShape;
import faultline.geometry.Disc;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The index of what stands at the start: the sides of the enclosure, then the outlines of the static obstacles. */
class StartIndexTest {

    private static final List<Vector2> OUTER = ring(1, 1, 5, 3);
    private static final List<Vector2> INNER = ring(2, 1.5, 4, 2.5);
    private static final Obstacle PLAN =
            new Obstacle("plan", new ObstacleShape.PlanShape(List.of(OUTER, INNER)), Pose.ORIGIN);
    private static final Obstacle POST =
            new Obstacle("post", new ObstacleShape.CircleShape(0.1), new Pose(5.5, 3.5, 0));
    private static final Obstacle VISITOR = new Obstacle(
            "visitor",
            new ObstacleShape.CircleShape(0.1),
            new Pose(0.5, 3.5, 0),
            new WaypointPath(0.1, false, List.of(new Vector2(0.5, 0.5))));
    private static final WorldSpec SPEC = new WorldSpec(6, 4, true, 1, List.of(PLAN, VISITOR, POST));

    private static List<Vector2> ring(double x, double y, double right, double top) {
        return List.of(new Vector2(x, y), new Vector2(right, y), new Vector2(right, top), new Vector2(x, top));
    }

    private static List<ConvexShape> sides(List<Vector2> ring) {
        List<ConvexShape> sides = new ArrayList<>();
        for (int i = 0; i < ring.size(); i++) {
            sides.add(new Segment(ring.get(i), ring.get((i + 1) % ring.size())));
        }
        return sides;
    }

    private static List<ConvexShape> expected(boolean enclosed) {
        List<ConvexShape> expected = new ArrayList<>(enclosed ? sides(ring(0, 0, 6, 4)) : List.of());
        expected.addAll(sides(OUTER));
        expected.addAll(sides(INNER));
        expected.add(new Disc(5.5, 3.5, 0.1));
        return expected;
    }

    private static void assertHolds(List<ConvexShape> expected, SpatialIndex index) {
        List<ConvexShape> shapes = new ArrayList<>();
        for (int i = 0; i < index.size(); i++) {
            shapes.add(index.shape(i));
        }
        assertEquals(expected, shapes);
        CandidateBuffer found = new CandidateBuffer();
        index.copy().findNear(3, 2, 10, found);
        assertEquals(expected.size(), found.size());
    }

    @Test
    void itHoldsTheEnclosureAndTheStaticObstaclesInTheirOrder() {
        assertHolds(expected(true), SpatialIndex.ofStaticShapes(SPEC));
        assertHolds(expected(true), new World(SPEC, RobotSpec.DEFAULT, new Pose(0.5, 0.5, 0), 0.01, 1).startIndex());
        assertHolds(expected(false), SpatialIndex.ofStaticShapes(new WorldSpec(6, 4, false, 1, SPEC.obstacles())));
    }

    @Test
    void bothIndicesHoldTheSame() {
        CandidateBuffer all = ObstacleSet.staticShapes(SPEC);
        assertHolds(expected(true), new GridIndex(all));
        assertHolds(expected(true), new BruteForceIndex(all));
    }

    @Test
    void manyShapesAreKeptInAGrid() {
        List<Obstacle> posts = new ArrayList<>();
        for (int i = 0; i < 1000; i++) {
            posts.add(new Obstacle("post" + i, new ObstacleShape.CircleShape(0.1), new Pose(i, 0, 0)));
        }
        assertTrue(SpatialIndex.ofStaticShapes(SPEC.withObstacles(posts)) instanceof GridIndex);
        assertTrue(SpatialIndex.ofStaticShapes(SPEC) instanceof BruteForceIndex);
    }

    @Test
    void betweenTheRingsOfAPlanIsItsInside() {
        ObstacleGeometry geometry = ObstacleGeometry.of(PLAN);
        assertTrue(geometry.contains(new Vector2(1.5, 2)) && geometry.contains(new Vector2(3, 1.2)));
        assertTrue(!geometry.contains(new Vector2(3, 2)) && !geometry.contains(new Vector2(0.5, 2)));
    }
}
