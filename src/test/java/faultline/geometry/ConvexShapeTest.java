package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Distance, nearest point, bounding circle and translation of each shape, against the points of its outline. */
class ConvexShapeTest {

    private static final int CASES = 60;
    private static final int OUTLINE_POINTS = 1000;
    private static final double TOLERANCE = 1e-12;

    private final SplittableRandom random = new SplittableRandom(2203);

    /** A shape and points of its outline, which are computed from its definition alone. */
    private record Sample(ConvexShape shape, List<Vector2> outline) {}

    private double coordinate() {
        return random.nextDouble(-3, 3);
    }

    private double size() {
        return random.nextDouble(0.05, 2);
    }

    private List<Sample> samples() {
        Segment segment = new Segment(coordinate(), coordinate(), coordinate(), coordinate());
        Disc disc = new Disc(coordinate(), coordinate(), size());
        Pose pose = new Pose(coordinate(), coordinate(), coordinate());
        double rx = size();
        double ry = size();
        return List.of(
                new Sample(segment, outline(part -> onLine(segment, part))),
                new Sample(disc, outline(part -> onEllipse(new Pose(disc.cx(), disc.cy(), 0), disc.radius(), 1, part))),
                new Sample(
                        new Ellipse(RigidMotion.of(pose), rx, ry),
                        outline(part -> onEllipse(pose, rx, ry / rx, part))));
    }

    private static List<Vector2> outline(DoubleFunction<Vector2> point) {
        return IntStream.rangeClosed(0, OUTLINE_POINTS)
                .mapToObj(i -> point.apply((double) i / OUTLINE_POINTS))
                .toList();
    }

    private static Vector2 onLine(Segment segment, double part) {
        return new Vector2(
                (1 - part) * segment.ax() + part * segment.bx(), (1 - part) * segment.ay() + part * segment.by());
    }

    private static Vector2 onEllipse(Pose pose, double rx, double ratio, double part) {
        double along = rx * Math.cos(2 * Math.PI * part);
        double aside = rx * ratio * Math.sin(2 * Math.PI * part);
        return new Vector2(
                pose.x() + along * Math.cos(pose.heading()) - aside * Math.sin(pose.heading()),
                pose.y() + along * Math.sin(pose.heading()) + aside * Math.cos(pose.heading()));
    }

    /** Returns the distance to the nearest of the points; that of the shape is less by at most their spacing. */
    private static double least(Vector2 point, List<Vector2> outline) {
        return outline.stream()
                .mapToDouble(other -> Math.hypot(other.x() - point.x(), other.y() - point.y()))
                .min()
                .orElseThrow();
    }

    @Test
    void theDistanceFromOutsideIsThatOfTheNearestPointOfTheOutline() {
        for (int i = 0; i < CASES; i++) {
            for (Sample sample : samples()) {
                Vector2 outside = sample.shape()
                        .centre()
                        .plus(Vector2.direction(coordinate())
                                .times(random.nextDouble(1.001, 4)
                                        * (0.01 + sample.shape().boundingRadius())));
                double distance = sample.shape().distanceTo(outside.x(), outside.y());
                double expected = least(outside, sample.outline());
                String name = sample.shape() + " from " + outside;
                assertTrue(distance <= expected + TOLERANCE, () -> name + ": " + distance + " > " + expected);
                assertEquals(expected, distance, 6e-3, name);
                Vector2 nearest = sample.shape().nearestTo(outside);
                assertEquals(
                        distance, Math.hypot(nearest.x() - outside.x(), nearest.y() - outside.y()), TOLERANCE, name);
                assertEquals(0, least(nearest, sample.outline()), 1e-2, name);
                assertEquals(0, sample.shape().distanceTo(nearest.x(), nearest.y()), 1e-9, name);
            }
        }
    }

    @Test
    void aPointInsideIsItsOwnNearestPoint() {
        for (int i = 0; i < CASES; i++) {
            for (Sample sample : samples().subList(1, 3)) {
                Vector2 rim = sample.outline().get(random.nextInt(OUTLINE_POINTS));
                Vector2 inside = rim.plus(sample.shape().centre().minus(rim).times(random.nextDouble(0.001, 1)));
                assertEquals(inside, sample.shape().nearestTo(inside));
                assertEquals(0, sample.shape().distanceTo(inside.x(), inside.y()));
            }
        }
    }

    @Test
    void theBoundingCircleTouchesTheFarthestPointOfTheOutline() {
        for (int i = 0; i < CASES; i++) {
            for (Sample sample : samples()) {
                Vector2 centre = sample.shape().centre();
                double farthest = sample.outline().stream()
                        .mapToDouble(point -> Math.hypot(point.x() - centre.x(), point.y() - centre.y()))
                        .max()
                        .orElseThrow();
                assertEquals(farthest, sample.shape().boundingRadius(), 2e-5, sample.shape()::toString);
            }
        }
    }

    @Test
    void theDistanceIsThatBetweenTheShapeAndThePointBothMoved() {
        for (int i = 0; i < CASES; i++) {
            double dx = coordinate();
            double dy = coordinate();
            Vector2 point = new Vector2(coordinate(), coordinate());
            for (Sample sample : samples()) {
                assertEquals(
                        sample.shape().distanceTo(point.x(), point.y()),
                        sample.shape().translated(dx, dy).distanceTo(point.x() + dx, point.y() + dy),
                        1e-9,
                        sample.shape()::toString);
            }
        }
    }

    @Test
    void aSegmentWithoutLengthIsAPoint() {
        Segment point = new Segment(1, 2, 1, 2);
        assertEquals(5, point.distanceTo(4, 6));
        assertEquals(new Vector2(1, 2), point.nearestTo(new Vector2(4, 6)));
        assertEquals(0, point.boundingRadius());
    }

    @Test
    void theCornersOfABoxGoRoundFromTheFrontLeft() {
        OrientedBox box = new OrientedBox(new Pose(1, 2, Math.PI / 2), 0.4, 0.2);
        List<Vector2> expected =
                List.of(new Vector2(0.9, 2.2), new Vector2(0.9, 1.8), new Vector2(1.1, 1.8), new Vector2(1.1, 2.2));
        List<Vector2> corners = new ArrayList<>();
        for (int i = 0; i < OrientedBox.CORNERS; i++) {
            corners.add(box.corner(i));
            assertEquals(0, expected.get(i).distanceTo(corners.get(i)), TOLERANCE, "corner " + i);
            assertEquals(box.boundingRadius(), corners.get(i).distanceTo(new Vector2(1, 2)), TOLERANCE);
        }
        assertEquals(Math.sqrt(0.05), box.boundingRadius(), TOLERANCE);
    }

    @Test
    void theNearestPointOfABoxIsOnTheSideThatFacesThePoint() {
        OrientedBox box = new OrientedBox(new Pose(1, 2, Math.PI / 2), 0.4, 0.2);
        assertEquals(0, new Vector2(1.05, 2.2).distanceTo(box.nearestTo(new Vector2(1.05, 3))), TOLERANCE);
        assertEquals(0, new Vector2(0.9, 1.9).distanceTo(box.nearestTo(new Vector2(-1, 1.9))), TOLERANCE);
        assertEquals(0, new Vector2(1.1, 1.8).distanceTo(box.nearestTo(new Vector2(5, 0))), TOLERANCE);
        assertEquals(0, new Vector2(1.05, 1.9).distanceTo(box.nearestTo(new Vector2(1.05, 1.9))), TOLERANCE);
    }
}
