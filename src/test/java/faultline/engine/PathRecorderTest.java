package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.geometry.Vector2;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class PathRecorderTest {

    private static final double STEP = 0.006;
    private final PathRecorder recorder = new PathRecorder();

    /** Goes straight ahead; point i lies at i steps. */
    private void drive(int from, int to) {
        for (int i = from; i < to; i++) {
            recorder.record(i * STEP, 1, PathTag.NONE);
        }
    }

    @Test
    void pointsNearerThanTheSpacingAreLeftOut() {
        recorder.record(0, 0, PathTag.NONE);
        recorder.record(0.004, 0, PathTag.NONE);
        recorder.record(0.006, 0, PathTag.NONE);
        RobotPath path = recorder.view();
        assertEquals(2, path.size());
        assertEquals(0.006, path.x(1));
    }

    @Test
    void aViewStaysAsItIsAndALaterOneContinuesIt() {
        drive(0, 100);
        RobotPath early = recorder.view();
        drive(100, 10_000);
        RobotPath late = recorder.view();
        assertEquals(100, early.size());
        assertEquals(10_000, late.size());
        assertTrue(late.isContinuationOf(early));
        assertFalse(early.isContinuationOf(late));
    }

    @Test
    void tooManyPointsOnALineAreThinnedToItsEnds() {
        drive(0, PathRecorder.MAX_POINTS);
        RobotPath full = recorder.view();
        drive(PathRecorder.MAX_POINTS, PathRecorder.MAX_POINTS + 1);
        RobotPath thinned = recorder.view();
        assertEquals(PathRecorder.MAX_POINTS, full.size());
        assertEquals(3, thinned.size());
        assertFalse(thinned.isContinuationOf(full));
        assertEquals(7 * STEP, full.x(7));
        assertEquals((PathRecorder.MAX_POINTS - 1) * STEP, thinned.x(1));
        assertEquals(PathRecorder.MAX_POINTS * STEP, thinned.x(2));
    }

    @Test
    void thePathOfARunOfHoursStaysWithinAPixelOfTheRobot() {
        // Fourteen hours at 0.3 m/s around a room of 3 m by 2 m whose corners are quarter circles of 0.2 m.
        double metres = 14 * 3600 * 0.3;
        for (double s = 0; s < metres; s += STEP) {
            Vector2 at = roomLoop(s);
            recorder.record(at.x(), at.y(), PathTag.NONE);
        }
        RobotPath path = recorder.view();
        int tail = 2000;
        double worst = 0;
        for (double s = metres - 40; s < metres - 20; s += 0.01) {
            worst = Math.max(worst, distanceToEnd(path, tail, roomLoop(s)));
        }
        assertTrue(worst < 0.004, "off by " + worst + " m");
        worst = 0;
        for (double s = 0; s < 20; s += 0.01) {
            worst = Math.max(worst, distanceToStart(path, tail, roomLoop(s)));
        }
        assertTrue(worst < 0.004, "off by " + worst + " m");
    }

    @Test
    void thePathOfARunOfDaysKeepsToTheWayOfTheRobot() {
        // Six days at 0.3 m/s.
        for (double s = 0; s < 150_000; s += 0.02) {
            Vector2 at = roomLoop(s);
            recorder.record(at.x(), at.y(), PathTag.NONE);
        }
        RobotPath path = recorder.view();
        double worst = 0;
        for (int i = 1; i < path.size(); i++) {
            Vector2 middle = new Vector2((path.x(i - 1) + path.x(i)) / 2, (path.y(i - 1) + path.y(i)) / 2);
            worst = Math.max(worst, distanceFromLoop(middle));
        }
        assertTrue(worst < 0.02, "off by " + worst + " m");
    }

    /** Returns the distance of a point from the curve of {@link #roomLoop}. */
    private static double distanceFromLoop(Vector2 point) {
        double radius = 0.2;
        double x = Math.abs(point.x() - 1.5) - (1.5 - radius);
        double y = Math.abs(point.y() - 1) - (1 - radius);
        return Math.abs(Math.hypot(Math.max(x, 0), Math.max(y, 0)) + Math.min(Math.max(x, y), 0) - radius);
    }

    @Test
    void thePartOfAThinnedPathThatAnEarlierOneCoveredEndsWhereThatEnded() {
        List<RobotPath> earlier = new ArrayList<>();
        List<Vector2> ends = new ArrayList<>();
        int points = 4 * PathRecorder.MAX_POINTS;
        for (int i = 0; i < points; i++) {
            Vector2 at = roomLoop(i * STEP);
            recorder.record(at.x(), at.y(), PathTag.NONE);
            if (i % 40_009 == 0) {
                earlier.add(recorder.view());
                ends.add(at);
            }
        }
        RobotPath newest = recorder.view();
        for (int i = 0; i < earlier.size(); i++) {
            RobotPath part = newest.prefix(earlier.get(i));
            assertTrue(newest.isContinuationOf(part), "shares its points");
            assertTrue(part.size() <= earlier.get(i).size());
            int last = part.size() - 1;
            // The next point that is kept is not before the end.
            int next = Math.min(part.size(), newest.size() - 1);
            assertEquals(
                    0,
                    Line2D.ptSegDist(
                            newest.x(last),
                            newest.y(last),
                            newest.x(next),
                            newest.y(next),
                            ends.get(i).x(),
                            ends.get(i).y()),
                    0.004);
        }
    }

    @Test
    void aReversalAndASpinOnTheSpotAreKept() {
        drive(0, PathRecorder.MAX_POINTS / 2);
        for (int i = PathRecorder.MAX_POINTS / 2; i > 0; i--) {
            recorder.record(i * STEP, 1, PathTag.NONE);
        }
        drive(0, 2);
        RobotPath path = recorder.view();
        double farthest = 0;
        for (int i = 0; i < path.size(); i++) {
            farthest = Math.max(farthest, path.x(i));
        }
        assertEquals(PathRecorder.MAX_POINTS / 2 * STEP, farthest, 2 * STEP);
    }

    /** Returns the point at a distance along a rounded rectangle that a robot circles repeatedly. */
    private static Vector2 roomLoop(double distance) {
        double radius = 0.2;
        double[] straight = {3 - 2 * radius, 2 - 2 * radius, 3 - 2 * radius, 2 - 2 * radius};
        double arc = radius * Math.PI / 2;
        double rest = distance % (10 - 8 * radius + 4 * arc);
        Vector2 at = new Vector2(radius, 0);
        double heading = 0;
        for (double side : straight) {
            Vector2 ahead = new Vector2(Math.cos(heading), Math.sin(heading));
            if (rest < side) {
                return at.plus(ahead.times(rest));
            }
            rest -= side;
            at = at.plus(ahead.times(side));
            Vector2 centre = at.plus(new Vector2(-ahead.y(), ahead.x()).times(radius));
            double turned = Math.min(rest, arc) / radius;
            Vector2 onArc =
                    centre.plus(new Vector2(Math.sin(heading + turned), -Math.cos(heading + turned)).times(radius));
            if (rest < arc) {
                return onArc;
            }
            rest -= arc;
            at = onArc;
            heading += Math.PI / 2;
        }
        return at;
    }

    private static double distanceToStart(RobotPath path, int points, Vector2 at) {
        return distance(path, 1, Math.min(points, path.size()), at);
    }

    private static double distanceToEnd(RobotPath path, int points, Vector2 at) {
        return distance(path, Math.max(1, path.size() - points), path.size(), at);
    }

    private static double distance(RobotPath path, int from, int to, Vector2 at) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = from; i < to; i++) {
            least = Math.min(
                    least, Line2D.ptSegDist(path.x(i - 1), path.y(i - 1), path.x(i), path.y(i), at.x(), at.y()));
        }
        return least;
    }

    @Test
    void aBlockIsLeftOutOnlyWhereItsBoxDoesNotTouchAndAllItsPointsArePresent() {
        drive(0, 100);
        RobotPath path = recorder.view();
        Rectangle2D nearTheStart = new Rectangle2D.Double(0, 0.5, 0.05, 1);
        Rectangle2D above = new Rectangle2D.Double(0, 2, 1, 1);
        assertEquals(0, path.skippablePoints(0, nearTheStart));
        assertEquals(64, path.skippablePoints(0, above));
        assertEquals(0, path.skippablePoints(1, above), "not the start of a stretch");
        assertEquals(0, path.skippablePoints(64, above), "only 36 points of it are there");
    }

    /** The state changes every 0.2 m along a line of 3 km, which thinning would otherwise leave with two points. */
    @Test
    void thinningKeepsTheLinesOfEachTagApart() {
        PathRecorder recorder = new PathRecorder();
        int end = 500_000;
        for (int i = 0; i <= end; i++) {
            recorder.record(i * 0.006, 1, tagAt(i * 0.006));
        }
        RobotPath path = recorder.view();
        assertTrue(path.size() < PathRecorder.MAX_POINTS);
        for (int i = 1; i < path.size(); i++) {
            double middle = (path.x(i - 1) + path.x(i)) / 2;
            boolean border = path.x(i) - path.x(i - 1) < 0.013;
            assertEquals(tagAt(path.x(i)), path.tag(i));
            assertTrue(border || path.tag(i) == tagAt(middle), "at " + middle);
        }
    }

    private static int tagAt(double x) {
        return PathTag.of(FollowerState.values()[(int) (x / 0.2) % 6], (int) (x / 0.2) % 5 == 0);
    }

    @Test
    void aChangeOfStateOnAShortWayIsKept() {
        PathRecorder recorder = new PathRecorder();
        recorder.record(0, 0, PathTag.NONE);
        recorder.record(0.002, 0, PathTag.of(FollowerState.FOLLOW, true));
        recorder.record(0.0025, 0, PathTag.NONE);
        RobotPath path = recorder.view();
        assertEquals(2, path.size());
        assertTrue(PathTag.isFaulty(path.tag(1)));
        assertEquals(FollowerState.FOLLOW.ordinal(), PathTag.stateIndex(path.tag(1)));
    }
}
