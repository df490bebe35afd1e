package faultline.app;

import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.trace.TraceColumn;
import faultline.io.JsonWriter;
import faultline.io.ProgramVersion;
import java.util.HexFormat;

/** The file beside a trace of format 2: which run it is of, and what its columns mean. */
final class TraceHeader {

    private TraceHeader() {}

    /** Returns the text of the file, given the name and the hash of the scenario and the simulation at its end. */
    static String text(String name, RunOptions options, String scenarioHash, Simulation simulation) {
        SimulationSetup setup = simulation.setup();
        JsonWriter json = new JsonWriter()
                .member("format", "faultline-trace-2")
                .member("program", ProgramVersion.text())
                .member("scenario", name)
                .member("scenario_file", options.file().getFileName().toString())
                .member("scenario_sha256", scenarioHash)
                .member("seed", setup.seed())
                .member("tick_s", setup.dt())
                .member("rows", simulation.ticks() + 1)
                .member("trajectory_hash", HexFormat.of().toHexDigits(simulation.trajectoryHash()))
                .name("columns")
                .beginArray();
        for (TraceColumn column : options.traceFormat().columns(simulation.robot())) {
            json.beginObject()
                    .member("name", column.name())
                    .member("unit", column.unit())
                    .member("meaning", column.meaning())
                    .endObject();
        }
        return json.endArray().finish() + "\n";
    }
}
