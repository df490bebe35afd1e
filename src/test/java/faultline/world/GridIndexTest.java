package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.geometry.ConvexShape;
import faultline.geometry.Disc;
import faultline.geometry.Ellipse;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The grid finds every shape within the distance once; brute force is the reference. */
class GridIndexTest {

    private static CandidateBuffer randomScene(SplittableRandom random, int size, double spread) {
        CandidateBuffer all = new CandidateBuffer();
        for (int i = 0; i < size; i++) {
            all.add(randomShape(random, spread), owner(i));
        }
        return all;
    }

    private static ShapeOwner owner(int number) {
        return new ShapeOwner("owner" + number, number, Obstacle.MATT);
    }

    private static ConvexShape randomShape(SplittableRandom random, double spread) {
        Vector2 at = new Vector2(random.nextDouble(-spread, spread), random.nextDouble(-spread, spread));
        double length = StrictMath.pow(10, random.nextDouble(-4, 1.5));
        Vector2 along = Vector2.direction(random.nextDouble(7)).times(length);
        return switch (random.nextInt(5)) {
            case 0 -> new Disc(at.x(), at.y(), length);
            case 1 -> new Ellipse(RigidMotion.of(new Pose(at.x(), at.y(), random.nextDouble(7))), length, length / 10);
            case 2 -> new Segment(at, at);
            case 3 -> new Segment(at.x(), at.y(), at.x() + length, at.y());
            default -> new Segment(at, at.plus(along));
        };
    }

    private static Set<Long> within(CandidateBuffer found, Vector2 point, double distance) {
        Set<Long> owners = new HashSet<>();
        for (int i = 0; i < found.size(); i++) {
            if (found.shape(i).nearestTo(point).distanceTo(point) <= distance) {
                owners.add(found.owner(i).order());
            }
        }
        return owners;
    }

    @Test
    void itFindsWhatBruteForceFindsAndEachFigureOnce() {
        SplittableRandom random = new SplittableRandom(61);
        for (int scene = 0; scene < 200; scene++) {
            double spread = StrictMath.pow(10, random.nextDouble(-1, 2.5));
            CandidateBuffer all = randomScene(random, random.nextInt(1, 300), spread);
            SpatialIndex first = new GridIndex(all);
            SpatialIndex copy = first.copy();
            for (int look = 0; look < 50; look++) {
                Vector2 point =
                        new Vector2(random.nextDouble(-1.5, 1.5) * spread, random.nextDouble(-1.5, 1.5) * spread);
                double distance = random.nextDouble(0, 2);
                CandidateBuffer found = new CandidateBuffer();
                SpatialIndex grid = random.nextBoolean() ? first : copy;
                grid.findNear(point.x(), point.y(), distance, found);
                assertEquals(
                        within(all, point, distance),
                        within(found, point, distance),
                        "scene " + scene + ", look " + look);
                Map<ConvexShape, Boolean> once = new IdentityHashMap<>();
                for (int i = 0; i < found.size(); i++) {
                    assertSame(found.shape(i), grid.shape(found.number(i)));
                    assertTrue(once.put(found.shape(i), true) == null, "found twice");
                }
            }
        }
    }

    /** Scenes whose grid has one cell, one row, very large cells, or one cell with nearly everything. */
    private static List<CandidateBuffer> degenerateScenes() {
        CandidateBuffer coincident = new CandidateBuffer();
        CandidateBuffer inLine = new CandidateBuffer(1);
        CandidateBuffer outlier = new CandidateBuffer();
        CandidateBuffer crossing = new CandidateBuffer(400);
        for (int i = 0; i < 200; i++) {
            Vector2 origin = new Vector2(0, 0);
            coincident.add(new Segment(origin, origin), owner(i));
            inLine.add(new Segment(0.4 * i, 0, 0.4 * (i + 1), 0), owner(i));
            outlier.add(new Segment(0.01 * i, 0, 0.01 * i, 1), owner(i));
            crossing.add(new Segment(origin, Vector2.direction(0.031 * i).times(100)), owner(i));
        }
        outlier.add(new Disc(1e8, -1e8, 0.1), owner(200));
        return List.of(coincident, inLine, outlier, crossing);
    }

    @Test
    void itFindsWhatBruteForceFindsInDegenerateScenes() {
        SplittableRandom random = new SplittableRandom(64);
        List<CandidateBuffer> scenes = degenerateScenes();
        for (CandidateBuffer all : scenes) {
            SpatialIndex grid = new GridIndex(all);
            for (int look = 0; look < 200; look++) {
                // Every second point is on the border of a cell.
                double x = 0.4 * random.nextInt(-5, 25) + (look % 2) * random.nextDouble(0.4);
                double y = 0.4 * random.nextInt(-5, 5) + (look % 2) * random.nextDouble(0.4);
                double distance = look % 3 * 0.4;
                CandidateBuffer found = new CandidateBuffer();
                grid.findNear(x, y, distance, found);
                Vector2 point = new Vector2(x, y);
                assertEquals(
                        within(all, point, distance),
                        within(found, point, distance),
                        "scene " + scenes.indexOf(all) + ", distance " + distance + " from " + point);
            }
        }
    }

    @Test
    void shapesKeepTheirNumbersWhenOthersAreDropped() {
        SplittableRandom random = new SplittableRandom(63);
        CandidateBuffer all = randomScene(random, 300, 5);
        for (SpatialIndex index : List.of(new GridIndex(all), new BruteForceIndex(all))) {
            CandidateBuffer found = new CandidateBuffer();
            index.findNear(1, 1, 3, found);
            int before = found.size();
            found.dropBeyond(1, 1, 0.5);
            assertTrue(found.size() > 1 && found.size() < before, "kept " + found.size() + " of " + before);
            for (int i = 0; i < found.size(); i++) {
                assertSame(found.shape(i), index.shape(found.number(i)));
                assertEquals(found.number(i), found.owner(i).order());
            }
        }
    }

    @Test
    void aQueryFindsFewOfMany() {
        SplittableRandom random = new SplittableRandom(62);
        CandidateBuffer all = new CandidateBuffer();
        for (int i = 0; i < 40_000; i++) {
            Vector2 at = new Vector2(random.nextDouble(100), random.nextDouble(100));
            all.add(
                    new Segment(
                            at, at.plus(Vector2.direction(random.nextDouble(7)).times(0.3))),
                    owner(i));
        }
        CandidateBuffer found = new CandidateBuffer();
        new GridIndex(all).findNear(50, 50, 1, found);
        // Four segments a square metre, a look of some 10 square metres with the cells' margins.
        assertTrue(found.size() < 200, "found " + found.size());
    }

    @Test
    void anEmptyIndexFindsNothing() {
        CandidateBuffer found = new CandidateBuffer();
        new GridIndex(new CandidateBuffer()).findNear(0, 0, 1, found);
        assertEquals(0, found.size());
    }

    /** Returns segments that are long for their cells: of any slope, nearly horizontal, vertical, and on borders. */
    private static CandidateBuffer longSegments(SplittableRandom random, int size) {
        CandidateBuffer all = new CandidateBuffer();
        for (int i = 0; i < size; i++) {
            double x = 0.4 * random.nextInt(-200, 200) + random.nextInt(2) * random.nextDouble(0.4);
            double y = 0.4 * random.nextInt(-200, 200) + random.nextInt(2) * random.nextDouble(0.4);
            double length = random.nextDouble(1, 150) * (random.nextBoolean() ? 1 : -1);
            double tilt = StrictMath.pow(10, random.nextDouble(-16, 1)) * (random.nextBoolean() ? 1 : -1);
            all.add(
                    switch (random.nextInt(4)) {
                        case 0 -> new Segment(x, y, x + length, y + tilt * length);
                        case 1 -> new Segment(x, y, x + tilt * length, y + length);
                        case 2 -> new Segment(x, y, x + length, y + length);
                        default -> new Segment(x, y, x + length, y + random.nextInt(-1, 2) * 0.4);
                    },
                    owner(i));
        }
        return all;
    }

    @Test
    void itFindsWhatBruteForceFindsAlongLongSegments() {
        SplittableRandom random = new SplittableRandom(65);
        for (int scene = 0; scene < 60; scene++) {
            CandidateBuffer all = longSegments(random, random.nextInt(1, 120));
            SpatialIndex grid = new GridIndex(all);
            for (int look = 0; look < 200; look++) {
                Segment segment = (Segment) all.shape(random.nextInt(all.size()));
                Vector2 point = segment.pointAt(random.nextDouble(-0.01, 1.01))
                        .plus(Vector2.direction(random.nextDouble(7)).times(random.nextDouble(1)));
                double distance = random.nextDouble(1.1);
                CandidateBuffer found = new CandidateBuffer();
                grid.findNear(point.x(), point.y(), distance, found);
                assertEquals(
                        within(all, point, distance),
                        within(found, point, distance),
                        "scene " + scene + ", distance " + distance + " from " + point);
            }
        }
    }

    @Test
    void manyLongSegmentsNeedTimeInProportionToTheCellsThatTheyCross() {
        CandidateBuffer all = new CandidateBuffer();
        for (int i = 0; i < 100_000; i++) {
            all.add(new Segment(0, 2e-4 * i, 500, 490 + 1e-4 * i), owner(i));
        }
        CpuTime time = CpuTime.start();
        assertEquals(100_000, new GridIndex(all).size());
        time.assertBelow(2);
    }
}
