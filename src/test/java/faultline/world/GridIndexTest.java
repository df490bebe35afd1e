package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Convex;
import faultline.geometry.Disc;
import faultline.geometry.Oval;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vec;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The grid finds whatever is within the distance, each figure once; brute force is the judge. */
class GridIndexTest {

    private static Candidates scene(SplittableRandom random, int size, double spread) {
        Candidates all = new Candidates();
        for (int i = 0; i < size; i++) {
            all.add(figure(random, spread), i);
        }
        return all;
    }

    private static Convex figure(SplittableRandom random, double spread) {
        Vec at = new Vec(random.nextDouble(-spread, spread), random.nextDouble(-spread, spread));
        double length = StrictMath.pow(10, random.nextDouble(-4, 1.5));
        Vec along = Vec.direction(random.nextDouble(7)).times(length);
        return switch (random.nextInt(5)) {
            case 0 -> new Disc(at.x(), at.y(), length);
            case 1 -> Oval.at(new Pose(at.x(), at.y(), random.nextDouble(7)), length, length / 10);
            case 2 -> new Segment(at, at);
            case 3 -> new Segment(at.x(), at.y(), at.x() + length, at.y());
            default -> new Segment(at, at.plus(along));
        };
    }

    private static Set<Integer> within(Candidates found, Vec point, double distance) {
        Set<Integer> owners = new HashSet<>();
        for (int i = 0; i < found.size(); i++) {
            if (found.figure(i).nearestTo(point).distanceTo(point) <= distance) {
                owners.add(found.owner(i));
            }
        }
        return owners;
    }

    @Test
    void itFindsWhatBruteForceFindsAndEachFigureOnce() {
        SplittableRandom random = new SplittableRandom(61);
        for (int scene = 0; scene < 200; scene++) {
            double spread = StrictMath.pow(10, random.nextDouble(-1, 2.5));
            Candidates all = scene(random, random.nextInt(1, 300), spread);
            FigureIndex grid = new GridIndex(all);
            for (int look = 0; look < 50; look++) {
                Vec point = new Vec(random.nextDouble(-1.5, 1.5) * spread, random.nextDouble(-1.5, 1.5) * spread);
                double distance = random.nextDouble(0, 2);
                Candidates found = new Candidates();
                grid.near(point.x(), point.y(), distance, found);
                assertEquals(within(all, point, distance), within(found, point, distance), "scene " + scene + ", look " + look);
                Map<Convex, Boolean> once = new IdentityHashMap<>();
                for (int i = 0; i < found.size(); i++) {
                    assertTrue(once.put(found.figure(i), true) == null, "found twice");
                }
            }
        }
    }

    @Test
    void aLookRoundFindsFewOfMany() {
        SplittableRandom random = new SplittableRandom(62);
        Candidates all = new Candidates();
        for (int i = 0; i < 40_000; i++) {
            Vec at = new Vec(random.nextDouble(100), random.nextDouble(100));
            all.add(new Segment(at, at.plus(Vec.direction(random.nextDouble(7)).times(0.3))), i);
        }
        Candidates found = new Candidates();
        new GridIndex(all).near(50, 50, 1, found);
        // Four segments a square metre, a look of some 10 square metres with the cells' margins.
        assertTrue(found.size() < 200, "found " + found.size());
    }

    @Test
    void anEmptyFieldHasNothingNear() {
        Candidates found = new Candidates();
        new GridIndex(new Candidates()).near(0, 0, 1, found);
        assertEquals(0, found.size());
    }
}
