package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A square room of 4 m with a table of 1 m in its middle; the way along the walls at 0.35 m is a square from 0.35 to
 * 3.65.
 */
class CoverageTest {

    private static final double WANTED = 0.35;
    private static final List<Vector2> LAP = square(WANTED);

    private final Coverage coverage = coverage(new WorldSpec(
            4, 4, true, 3, List.of(new Obstacle("table", new ObstacleShape.RectangleShape(1, 1), new Pose(2, 2, 0)))));

    private static Coverage coverage(WorldSpec world) {
        return new Coverage(new WallReference(world), WANTED);
    }

    /** The corners of a square about the middle of the room, so far in from the walls, the first one twice. */
    private static List<Vector2> square(double in) {
        return List.of(
                new Vector2(in, in),
                new Vector2(4 - in, in),
                new Vector2(4 - in, 4 - in),
                new Vector2(in, 4 - in),
                new Vector2(in, in));
    }

    /** Visits points every 5 mm along a way. */
    private void visit(List<Vector2> way) {
        visit(coverage, way);
    }

    private static void visit(Coverage coverage, List<Vector2> way) {
        for (int i = 1; i < way.size(); i++) {
            Vector2 from = way.get(i - 1);
            Vector2 all = way.get(i).minus(from);
            for (double done = 0; done <= all.length(); done += 0.005) {
                coverage.visit(from.plus(all.times(done / all.length())));
            }
        }
    }

    private double share() {
        return coverage.share().orElse(-1);
    }

    @Test
    void aLapIsAll() {
        visit(LAP);
        assertEquals(1, share());
    }

    @Test
    void laterLapsAddNothing() {
        visit(LAP);
        visit(LAP);
        assertEquals(1, share());
    }

    @Test
    void halfALapIsHalf() {
        visit(LAP.subList(0, 3));
        assertEquals(0.5, share(), 0.015, "two sides of four, and 5 cm round the corner at either end");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.31, 0.39})
    void fourCentimetresOffIsStillThere(double distance) {
        visit(square(distance));
        assertEquals(1, share(), 0.01, "but for the very corners, which are farther off across");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.29, 0.41})
    void sixCentimetresOffIsNotThere(double distance) {
        visit(List.of(new Vector2(1, distance), new Vector2(3, distance)));
        assertTrue(coverage.share().isEmpty());
    }

    /** The places of the wall are 0.135 m from the first point, and 0.04 m from the last one. */
    @Test
    void aWallThatTheRobotReachesOnlyAtTheEndIsPassed() {
        coverage.visit(new Vector2(2, 0.485));
        coverage.visit(new Vector2(2, 0.41));
        coverage.visit(new Vector2(2, 0.39));
        assertEquals(0.06 / (4 * 3.3), share(), 0.001);
    }

    /** Places at 1.5 m from a thin pole are 0.3 m apart, so the middle one is more than a square from most others. */
    @Test
    void placesFarFromTheMiddleOfThoseAroundAPoleArePassed() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.05), new Pose(5, 5, 0));
        Coverage around = new Coverage(new WallReference(new WorldSpec(10, 10, false, 3, List.of(pole))), 1.5);
        around.visit(new Vector2(5 - 1.55, 5));
        assertTrue(around.share().isPresent());
    }

    /** The places around a pole are farther from each other than along its edge, but one piece. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.02, 0.05, 0.1, 0.2, 0.25, 0.5})
    void aThirdOfThePathAroundAPoleIsAThird(double radius) {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(radius), new Pose(2, 2, 0));
        Coverage around = coverage(new WorldSpec(4, 4, false, 3, List.of(pole)));
        for (double angle = 0; angle <= 2 * Math.PI / 3; angle += 0.002) {
            around.visit(new Vector2(2, 2).plus(Vector2.direction(angle).times(radius + WANTED)));
        }
        // The tolerance is passed at both ends.
        double tolerance = Coverage.TOLERANCE / (radius + WANTED) / Math.PI;
        assertEquals(1 / 3.0 + tolerance, around.share().orElseThrow(), 0.02);
    }

    /** The path of this ellipse turns at its ends by half a circle, where its edge is nearly a point. */
    @Test
    void thePathAroundAPointedEllipseIsOnePiece() {
        Obstacle leaf = new Obstacle("leaf", new ObstacleShape.EllipseShape(0.6, 0.02), new Pose(2, 2, 0));
        Coverage around = coverage(new WorldSpec(4, 4, false, 3, List.of(leaf)));
        for (double x = -0.5; x <= 0.5; x += 0.002) {
            around.visit(new Vector2(2 + x, 2 + WANTED));
        }
        assertEquals(0.45, around.share().orElseThrow(), 0.05);
    }

    /** More than 100 000 places around it are in a few cells. */
    @Test
    void anEllipseThatIsNearlyASegmentTakesLittleTime() {
        Obstacle blade = new Obstacle("blade", new ObstacleShape.EllipseShape(0.01, 1e-6), new Pose(2, 2, 0));
        Coverage around = coverage(new WorldSpec(4, 4, false, 3, List.of(blade)));
        visit(around, List.of(new Vector2(1.9, 2 + WANTED), new Vector2(2.1, 2 + WANTED)));
        CpuTime time = CpuTime.start();
        assertEquals(1, around.share().orElseThrow(), 0.01, "the places on its two sides are not joined");
        time.assertBelow(3);
    }

    @Test
    void thinEllipsesHaveTheSameBitsAsComparingAllPlaces() {
        Random random = new Random(815);
        for (int i = 0; i < 4; i++) {
            List<Obstacle> blades = new ArrayList<>();
            for (int k = 0; k < 2; k++) {
                Pose pose = new Pose(
                        2 + 0.1 * random.nextDouble(), 2 + 0.03 * random.nextDouble(), random.nextInt(3) * 0.1);
                double thin = List.of(1e-6, 2e-4, 1e-3).get(random.nextInt(3));
                blades.add(new Obstacle("blade" + k, new ObstacleShape.EllipseShape(0.02, thin), pose));
            }
            WallReference walls = new WallReference(new WorldSpec(4, 4, false, 3, blades));
            Coverage lazy = new Coverage(walls, WANTED);
            EagerCoverage eager = new EagerCoverage(walls, WANTED);
            for (double x = 1.9; x < 2.3; x += 0.01) {
                Vector2 point = new Vector2(x, 2 + WANTED);
                lazy.visit(point);
                eager.visit(point);
            }
            assertEquals(eager.share(), lazy.share(), "world " + i);
        }
    }

    @Test
    void aRecordIsEmptyUntilAPointIsRecorded() {
        assertTrue(coverage.isEmpty());
        visit(LAP);
        assertEquals(1, share());
        assertFalse(coverage.isEmpty());
    }

    @Test
    void nothingPassedIsNoShare() {
        assertTrue(coverage.share().isEmpty());
    }

    @Test
    void theCoverageOfARobotThatFollowsTheTableIsThatOfTheTable() {
        visit(square(1.5 - WANTED));
        assertEquals(1, share());
    }

    @Test
    void aDistanceForWhichThereIsNoRoomTakesLittleTime() {
        Coverage distant = new Coverage(new WallReference(new WorldSpec(4, 4, true, 3, List.of())), 20_000);
        visit(distant, LAP);
        CpuTime time = CpuTime.start();
        assertTrue(distant.share().isEmpty());
        time.assertBelow(2);
    }

    @Test
    void ofTwoWallsTheOneOfWhichMoreWasPassedWasFollowed() {
        visit(List.of(new Vector2(1.5, 1.15), new Vector2(2.5, 1.15)));
        visit(LAP.subList(0, 2));
        assertEquals(0.25, share(), 0.015, "one side of the room, not one side of the table");
    }

    @Test
    void partsThatNoRobotReachesDoNotCount() {
        Obstacle slot = new Obstacle(
                "slot", new ObstacleShape.WallShape(List.of(new Vector2(0, 3.6), new Vector2(3, 3.6))), Pose.ORIGIN);
        Coverage cramped = coverage(new WorldSpec(4, 4, true, 3, List.of(slot)));
        List<Vector2> belowTheSlot = List.of(
                new Vector2(0.35, 0.35),
                new Vector2(3.65, 0.35),
                new Vector2(3.65, 3.65),
                new Vector2(3.35, 3.65),
                new Vector2(3.25, 3.35),
                new Vector2(3, 3.25),
                new Vector2(0.35, 3.25),
                new Vector2(0.35, 0.35));
        visit(cramped, belowTheSlot);
        assertEquals(1, cramped.share().orElse(-1), "though 3 m of wall lie behind the slot, 0.4 m wide");
    }

    /** Shapes that touch, overlap, leave gaps about as wide as the robot's way, and repeat each other. */
    static WorldSpec clutter(Random random) {
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 0; i < 3 + random.nextInt(12); i++) {
            Pose pose = new Pose(8 * random.nextDouble(), 6 * random.nextDouble(), random.nextInt(8) * Math.PI / 4);
            ObstacleShape shape =
                    switch (random.nextInt(5)) {
                        case 0 -> new ObstacleShape.CircleShape(0.02 + random.nextDouble());
                        case 1 ->
                            new ObstacleShape.EllipseShape(0.05 + random.nextDouble(), 0.01 + random.nextDouble());
                        case 2 ->
                            new ObstacleShape.WallShape(List.of(
                                    Vector2.ZERO,
                                    new Vector2(3 * random.nextDouble(), 0),
                                    new Vector2(3 * random.nextDouble(), 2)));
                        default ->
                            new ObstacleShape.RectangleShape(
                                    0.01 + 2 * random.nextDouble(), 0.01 + random.nextDouble());
                    };
            obstacles.add(new Obstacle("o" + i, shape, pose));
            if (random.nextInt(4) == 0) {
                obstacles.add(new Obstacle("twin" + i, shape, pose));
            }
        }
        return new WorldSpec(8, 6, random.nextBoolean(), 3, obstacles);
    }

    /** Staircases of 5 cm, as in a floor plan, some of which return on themselves, and specks at their corners. */
    static WorldSpec staircases(Random random) {
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 0; i < 2 + random.nextInt(3); i++) {
            List<Vector2> points = new ArrayList<>(List.of(new Vector2(2 + random.nextInt(3), 1 + random.nextInt(3))));
            for (int k = 0; k < 60; k++) {
                double step = 0.05 * (random.nextInt(4) - 1);
                Vector2 by = k % 2 == 0 ? new Vector2(step, 0) : new Vector2(0, step);
                points.add(points.get(k).plus(by));
            }
            obstacles.add(new Obstacle("stairs" + i, new ObstacleShape.WallShape(points), Pose.ORIGIN));
            Vector2 corner = points.get(random.nextInt(points.size()));
            Pose beside = new Pose(corner.x() + 0.025, corner.y() + 0.025, 0);
            obstacles.add(new Obstacle("speck" + i, new ObstacleShape.RectangleShape(0.05, 0.05), beside));
        }
        return new WorldSpec(8, 6, true, 3, obstacles);
    }

    @Test
    void thePlacesAlongAllWallsAreThoseThatBruteForceFinds() {
        Random random = new Random(814);
        for (int i = 0; i < 30; i++) {
            WorldSpec world = i % 2 == 0 ? staircases(random) : clutter(random);
            WallReference walls = new WallReference(world);
            double wanted = List.of(0.012, 0.2, 0.35, 0.7, 1.5).get(random.nextInt(5));
            double spacing = wanted / (5 + random.nextInt(20));
            assertTrue(
                    walls.samplesAlongPath(wanted, spacing)
                            .equals(BruteForceSamples.of(walls, wanted, spacing, wanted, Double.POSITIVE_INFINITY)),
                    "world " + i);
        }
    }

    @Test
    void whatIsSampledOnDemandGivesTheSameBitsAsSamplingAllWalls() {
        Random random = new Random(813);
        int present = 0;
        for (int i = 0; i < 60; i++) {
            WorldSpec world = i % 3 == 0 ? staircases(random) : clutter(random);
            double wanted = List.of(0.012, 0.2, 0.35, 0.7, 1.5).get(random.nextInt(5));
            WallReference walls = new WallReference(world);
            Coverage lazy = new Coverage(walls, wanted);
            EagerCoverage eager = new EagerCoverage(walls, wanted);
            List<WallReference.WallSample> places = walls.samples(wanted, 0.01, 0);
            for (int stretch = 0; stretch < 3 && !places.isEmpty(); stretch++) {
                int from = random.nextInt(places.size());
                for (int k = from; k < Math.min(places.size(), from + 400); k++) {
                    Vector2 point = places.get(k)
                            .position()
                            .plus(new Vector2(0.06 * random.nextDouble(), 0.06 * random.nextDouble()));
                    lazy.visit(point);
                    eager.visit(point);
                }
                if (random.nextBoolean()) {
                    assertEquals(eager.share(), lazy.share(), "world " + i + " in the middle of a run");
                }
            }
            assertEquals(eager.share(), lazy.share(), "world " + i);
            present += lazy.share().isPresent() ? 1 : 0;
        }
        assertTrue(present > 40, present + " worlds had a way");
    }

    @Test
    void onlyWallsConnectedToThoseNearTheRobotAreSampled() {
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 0; i < 1000; i++) {
            Pose pose = new Pose(5 + 3 * (i % 40), 5 + 3 * (i / 40), 0);
            obstacles.add(new Obstacle("o" + i, new ObstacleShape.RectangleShape(0.5, 0.5), pose));
        }
        WorldSpec world = new WorldSpec(130, 90, true, 3, obstacles);
        PlaceMap places = new PlaceMap(new WallReference(world), WANTED, 0.01, 0.025, Coverage.MAX_PATH_PLACES);
        places.sampleNear(new Vector2(65, 41 + 0.25 + WANTED), 0.1);
        PlaceBlock touched = places.blocks().stream()
                .flatMap(List::stream)
                .filter(block -> block.isFree(0))
                .findFirst()
                .orElseThrow();
        places.fill(touched, 0, 0);
        assertEquals(4, places.blocks().size(), "the sides of one of 1000 squares");
    }

    @Test
    void thereIsNoShareIfTheWallHasTooManyPlaces() {
        // The table has 4 x 99 free places at its sides, and 55 or more around each corner.
        WorldSpec world = new WorldSpec(
                4,
                4,
                false,
                3,
                List.of(new Obstacle("table", new ObstacleShape.RectangleShape(0.99, 0.99), new Pose(2, 2, 0))));
        WallReference walls = new WallReference(world);
        Coverage enough = new Coverage(walls, WANTED, 1000);
        visit(enough, square(1.5 - WANTED));
        assertTrue(enough.share().isPresent());
        assertFalse(enough.isPathTooLong());
        Coverage tooFew = new Coverage(walls, WANTED, 500);
        visit(tooFew, square(1.5 - WANTED));
        assertTrue(tooFew.share().isEmpty());
        assertTrue(tooFew.isPathTooLong());
        visit(tooFew, LAP);
        assertTrue(tooFew.share().isEmpty(), "for the rest of the run");
    }

    @Test
    void aWorldOfManyKilometresTakesLittleTime() {
        Coverage huge = new Coverage(new WallReference(new WorldSpec(10_000, 10_000, true, 3, List.of())), WANTED);
        visit(huge, List.of(new Vector2(WANTED, WANTED), new Vector2(WANTED + 100, WANTED)));
        assertEquals(100.05 / (4 * (10_000 - 2 * WANTED)), huge.share().orElseThrow(), 1e-5);
    }
}
