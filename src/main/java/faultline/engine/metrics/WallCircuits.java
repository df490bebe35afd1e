package faultline.engine.metrics;

import faultline.engine.SimulationSetup;
import faultline.engine.walls.WallCircuit;
import faultline.engine.walls.WallReference;
import faultline.world.WorldSpec;
import java.util.LinkedHashMap;
import java.util.Map;

/** The circuits of worlds, found once for all runs in the same world; the latest are kept. Safe on any thread. */
public final class WallCircuits {

    private static final int MAX_KEPT = 16;

    private final Map<CircuitKey, WallCircuit> kept = new LinkedHashMap<>(MAX_KEPT, 0.75f, true);

    /** Creates a cache without circuits. */
    public WallCircuits() {}

    /** The distance is not a number for robots that follow no wall. */
    private record CircuitKey(WorldSpec world, double distance, double width) {}

    /**
     * {@return {@link CarryOnMetrics#circuit}, perhaps found by an earlier call}
     *
     * @param setup the setup of the run
     * @throws WallReference.PathTooLongException if the path is too long
     */
    public WallCircuit forCarryOn(SimulationSetup setup) {
        SimulationSetup firstTick = FirstTick.setup(setup);
        CircuitKey key = new CircuitKey(
                firstTick.world(),
                CarryOnMetrics.wantedDistance(firstTick).orElse(Double.NaN),
                firstTick.robot().width());
        synchronized (kept) {
            WallCircuit known = kept.get(key);
            if (known != null) {
                return known;
            }
        }
        WallCircuit circuit = CarryOnMetrics.circuit(firstTick);
        synchronized (kept) {
            kept.put(key, circuit);
            while (kept.size() > MAX_KEPT || keptPlaces() > WallReference.MAX_PLACES) {
                kept.remove(kept.keySet().iterator().next());
            }
        }
        return circuit;
    }

    private long keptPlaces() {
        return kept.values().stream().mapToLong(WallCircuit::size).sum();
    }
}
