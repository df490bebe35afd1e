package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.CpuTime;
import faultline.geometry.Vector2;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Paths and passed places agree with comparing every place with every other. */
class WallCircuitTest {

    private static final double SPACING = 0.02;
    private static final double JOIN = 0.04;
    private static final double TOLERANCE = 0.15;

    @Test
    void pathsOfPlacesOnALatticeAgreeWithBruteForce() {
        Random random = new Random(5);
        for (int round = 0; round < 40; round++) {
            double step = round % 2 == 0 ? JOIN : 0.025;
            double origin = random.nextInt(3) * 1000 - 1000;
            List<WallReference.WallSample> places = new ArrayList<>();
            for (int i = 0; i < 300; i++) {
                Vector2 at = new Vector2(origin + step * random.nextInt(30), origin - step * random.nextInt(30));
                places.add(new WallReference.WallSample(at, Vector2.ZERO, SPACING));
            }
            assertAgrees(places, random);
        }
    }

    @Test
    void pathsInTheOfficeAgreeWithBruteForce() throws ScenarioException {
        WallReference walls =
                new WallReference(Scenario.loadShipped("office.xml").setup().world());
        assertAgrees(walls.samplesAlongPath(0.35, SPACING), new Random(6));
    }

    /** In each swarm, every place is a few tenths of a millimetre from the one before it. */
    @Test
    void pathsOfDensePlacesAgreeWithBruteForce() {
        Random random = new Random(7);
        for (int round = 0; round < 20; round++) {
            List<WallReference.WallSample> places = new ArrayList<>();
            for (int swarm = 0; swarm < 6; swarm++) {
                double x = 0.3 * random.nextDouble();
                double y = 0.3 * random.nextDouble();
                for (int i = 0; i < 50; i++) {
                    x += 0.0004 * (random.nextDouble() - 0.3);
                    y += 0.0004 * (random.nextDouble() - 0.3);
                    places.add(new WallReference.WallSample(new Vector2(x, y), Vector2.ZERO, SPACING));
                }
            }
            assertAgrees(places, random);
        }
    }

    @Test
    void manyPlacesInOneCellTakeLittleTime() {
        CpuTime time = CpuTime.start();
        List<WallReference.WallSample> places = IntStream.range(0, 200_000)
                .mapToObj(i -> new WallReference.WallSample(new Vector2(i * 5e-7, 0), Vector2.ZERO, SPACING))
                .toList();
        assertEquals(200_000 * SPACING, new WallCircuit(places, SPACING, JOIN, TOLERANCE).maxLength(), 1e-6);
        time.assertBelow(5);
    }

    private static void assertAgrees(List<WallReference.WallSample> places, Random random) {
        WallCircuit circuit = new WallCircuit(places, SPACING, JOIN, TOLERANCE);
        int[] paths = bruteForcePaths(places);
        double[] lengths = new double[places.size()];
        for (int i = 0; i < paths.length; i++) {
            assertEquals(paths[i], circuit.path(i), "place " + i);
            lengths[paths[i]] += SPACING;
        }
        for (int i = 0; i < paths.length; i++) {
            assertEquals(lengths[i], circuit.length(i));
        }
        assertEquals(DoubleStream.of(lengths).max().orElse(0), circuit.maxLength());
        for (int i = 0; i < 100; i++) {
            Vector2 near = places.get(random.nextInt(places.size())).position();
            Vector2 point = near.plus(new Vector2(0.05 * random.nextInt(5), 0.05 * random.nextInt(5)));
            List<Integer> passed = new ArrayList<>();
            circuit.forEachPassed(point, passed::add);
            assertEquals(
                    within(places, point, TOLERANCE), passed.stream().sorted().toList());
            int nearest = circuit.nearestPlace(point);
            double least = places.get(nearest).position().distanceTo(point);
            assertEquals(within(places, point, least).get(0), nearest);
        }
    }

    private static List<Integer> within(List<WallReference.WallSample> places, Vector2 point, double radius) {
        return IntStream.range(0, places.size())
                .filter(i -> places.get(i).position().distanceTo(point) <= radius)
                .boxed()
                .toList();
    }

    /** Returns the first place of the path of each place. */
    private static int[] bruteForcePaths(List<WallReference.WallSample> places) {
        int[] paths = IntStream.range(0, places.size()).toArray();
        for (int i = 0; i < paths.length; i++) {
            for (int other : within(places.subList(0, i), places.get(i).position(), JOIN)) {
                int low = Math.min(paths[i], paths[other]);
                int high = Math.max(paths[i], paths[other]);
                for (int k = 0; k <= i; k++) {
                    paths[k] = paths[k] == high ? low : paths[k];
                }
            }
        }
        return paths;
    }
}
