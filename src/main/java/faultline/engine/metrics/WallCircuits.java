package faultline.engine.metrics;

import faultline.engine.SimulationSetup;
import faultline.engine.walls.WallCircuit;
import faultline.engine.walls.WallReference;
import faultline.world.WorldSpec;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Function;

/**
 * The circuits of worlds, found once for all runs in the same world; the latest are kept. Safe on any thread: if
 * several threads need the same circuit, one of them finds it while the others wait.
 */
public final class WallCircuits {

    private static final int MAX_KEPT = 16;

    private final Function<SimulationSetup, WallCircuit> finder;
    private final Map<CircuitKey, WallCircuit> kept = new LinkedHashMap<>(MAX_KEPT, 0.75f, true);
    /** The searches that have not ended. Guarded by {@link #kept}. */
    private final Map<CircuitKey, FutureTask<WallCircuit>> searches = new HashMap<>();

    /** Creates a cache without circuits. */
    public WallCircuits() {
        this(CarryOnMetrics::circuit);
    }

    /** Creates a cache whose circuits are found by a function of the setup of the first tick. */
    WallCircuits(Function<SimulationSetup, WallCircuit> finder) {
        this.finder = finder;
    }

    /** The distance is not a number for robots that follow no wall. */
    private record CircuitKey(WorldSpec world, double distance, double width) {}

    /**
     * {@return {@link CarryOnMetrics#circuit}, perhaps found by another call} If the search for it fails, all calls
     * that wait for it fail in the same way, and a later call searches again.
     *
     * @param setup the setup of the run
     * @throws WallReference.PathTooLongException if the path is too long
     * @throws CancellationException if this thread is interrupted while it waits for another call
     */
    public WallCircuit forCarryOn(SimulationSetup setup) {
        SimulationSetup firstTick = FirstTick.setup(setup);
        CircuitKey key = new CircuitKey(
                firstTick.world(),
                CarryOnMetrics.wantedDistance(firstTick).orElse(Double.NaN),
                firstTick.robot().width());
        FutureTask<WallCircuit> search;
        synchronized (kept) {
            WallCircuit known = kept.get(key);
            if (known != null) {
                return known;
            }
            search = searches.computeIfAbsent(key, missing -> new FutureTask<>(() -> find(missing, firstTick)));
        }
        // Does nothing if another thread runs it.
        search.run();
        return result(search);
    }

    private WallCircuit find(CircuitKey key, SimulationSetup firstTick) {
        try {
            WallCircuit circuit = finder.apply(firstTick);
            keep(key, circuit);
            return circuit;
        } finally {
            synchronized (kept) {
                searches.remove(key);
            }
        }
    }

    private void keep(CircuitKey key, WallCircuit circuit) {
        synchronized (kept) {
            kept.put(key, circuit);
            while (kept.size() > MAX_KEPT || keptPlaces() > WallReference.MAX_PLACES) {
                kept.remove(kept.keySet().iterator().next());
            }
        }
    }

    private static WallCircuit result(FutureTask<WallCircuit> search) {
        try {
            return search.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) e.getCause();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException("interrupted while another thread searched the walls");
        }
    }

    private long keptPlaces() {
        return kept.values().stream().mapToLong(WallCircuit::size).sum();
    }
}
