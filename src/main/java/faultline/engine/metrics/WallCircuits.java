package faultline.engine.metrics;

import faultline.engine.SimulationSetup;
import faultline.world.WorldSpec;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Supplier;

/** The circuits of worlds, found once for all runs in the same world; the latest are kept. Safe on any thread. */
public final class WallCircuits {

    private static final int MAX_KEPT = 16;

    private final Map<Key, WallCircuit> kept = new LinkedHashMap<>(MAX_KEPT, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Key, WallCircuit> eldest) {
            return size() > MAX_KEPT;
        }
    };

    /** Creates a cache without circuits. */
    public WallCircuits() {}

    private record Key(WorldSpec world, double distance, boolean coverage) {}

    /**
     * {@return the circuit for {@link CarryOnMetrics}}
     *
     * @param setup the setup of the run
     */
    public WallCircuit forCarryOn(SimulationSetup setup) {
        OptionalDouble distance = CarryOnMetrics.wantedDistance(setup);
        return distance.isEmpty()
                ? WallCircuit.empty()
                : get(
                        new Key(setup.world(), distance.getAsDouble(), false),
                        () -> WallCircuit.forCarryOn(setup.world(), distance.getAsDouble()));
    }

    /** Returns the circuit for {@link Coverage}. */
    WallCircuit forCoverage(SimulationSetup setup, WallReference walls, double distance) {
        return get(new Key(setup.world(), distance, true), () -> WallCircuit.forCoverage(walls, distance));
    }

    private WallCircuit get(Key key, Supplier<WallCircuit> maker) {
        synchronized (kept) {
            WallCircuit known = kept.get(key);
            if (known != null) {
                return known;
            }
        }
        WallCircuit circuit = maker.get();
        synchronized (kept) {
            kept.put(key, circuit);
        }
        return circuit;
    }
}
