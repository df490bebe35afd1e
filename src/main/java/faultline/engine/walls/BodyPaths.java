package faultline.engine.walls;

import faultline.world.WorldSpec;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * The closed paths on which a robot's body can follow the walls, also through passages that are too narrow for the
 * places of a {@link WallCircuit} on both sides. Each place of the circuit is beside one of them: that of the nearest
 * point of the wall. Immutable.
 */
public final class BodyPaths {

    /** The greatest spacing of the places of these paths, metres; they are joined up to twice the spacing. */
    private static final double MAX_SPACING = 0.02;

    private final int[] paths;
    private final double[] lengths;
    private final double maxLength;

    private BodyPaths(int[] paths, double[] lengths) {
        this.paths = paths;
        this.lengths = lengths;
        maxLength = DoubleStream.of(lengths).max().orElse(0);
    }

    /** Returns the paths of a circuit that leads through all passages. */
    static BodyPaths same(WallCircuit circuit) {
        int[] paths = IntStream.range(0, circuit.size()).map(circuit::path).toArray();
        return new BodyPaths(
                paths,
                IntStream.range(0, paths.length).mapToDouble(circuit::length).toArray());
    }

    /**
     * {@return the paths through all passages that are wider than a platform; if there are too many places, those of
     * the circuit}
     *
     * @param circuit the circuit
     * @param distance the distance of its places from the walls, metres
     * @param world its world
     * @param width the width of the platform, metres
     */
    public static BodyPaths of(WallCircuit circuit, double distance, WorldSpec world, double width) {
        if (width / 2 >= distance) {
            return same(circuit);
        }
        // Places on both sides of a thin wall are as far apart as the platform is wide, so that they are not joined.
        double spacing = Math.min(MAX_SPACING, width / 4);
        double bodyDistance = width / 2;
        try {
            List<WallReference.WallSample> places = new WallReference(world).samplesAlongPath(bodyDistance, spacing);
            return beside(circuit, bodyDistance, new JoinedPlaces(places, 2 * spacing));
        } catch (WallReference.PathTooLongException e) {
            return same(circuit);
        }
    }

    private static BodyPaths beside(WallCircuit circuit, double bodyDistance, JoinedPlaces body) {
        int[] paths = new int[circuit.size()];
        double[] lengths = new double[paths.length];
        CellNumbers firstPlaces = new CellNumbers();
        for (int i = 0; i < paths.length; i++) {
            paths[i] = i;
            int path = body.pathNear(circuit.place(i).atDistance(bodyDistance));
            if (path != JoinedPlaces.NONE) {
                int first = firstPlaces.get(path);
                paths[i] = first == CellNumbers.NONE ? i : first;
                firstPlaces.put(path, paths[i]);
            }
            lengths[paths[i]] += circuit.spacing();
        }
        return new BodyPaths(paths, lengths);
    }

    /**
     * {@return the path beside a place, identified by the first place beside it}
     *
     * @param place the index of the place
     */
    public int path(int place) {
        return paths[place];
    }

    /**
     * {@return the approximate length of the places beside a path, metres}
     *
     * @param path the index of the first place beside it
     */
    public double length(int path) {
        return lengths[path];
    }

    /** {@return the greatest length of the places beside a path, metres; 0 if there is none} */
    public double maxLength() {
        return maxLength;
    }
}
