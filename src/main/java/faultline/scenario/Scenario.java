package faultline.scenario;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.io.AtomicFile;
import java.io.IOException;
import java.nio.file.Path;

/**
 * One scenario: what a file holds. A user's test needs three lines:
 *
 * <pre>{@code
 * ScenarioRun run = Scenario.load(Path.of("scenarios/office.xml")).run();
 * assertEquals(List.of(), run.unmetExpectations());
 * assertTrue(run.collision().isEmpty());
 * }</pre>
 *
 * @param name for people; on one line
 * @param description for people, may be empty; on one line
 * @param recorded whether this is the record of a run that had come to its duration: the window replays it up to there,
 *     and holds
 * @param setup all that determines the run
 * @param expectation what the run is expected to give
 */
public record Scenario(
        String name, String description, boolean recorded, SimulationSetup setup, Expectation expectation) {

    /** How long a run lasts where a file does not say, seconds. */
    public static final double DEFAULT_DURATION = 120;

    /** The length of a tick where a file does not say, seconds. */
    public static final double DEFAULT_TICK = 0.01;

    /** The seed where a file does not say. */
    public static final long DEFAULT_SEED = 1;

    public Scenario {
        name = XmlText.oneLine(name);
        description = XmlText.oneLine(description);
    }

    /**
     * Reads a scenario file.
     *
     * @param file the file
     * @return the scenario
     * @throws ScenarioException with everything that is wrong with the file
     */
    public static Scenario load(Path file) throws ScenarioException {
        return ScenarioReader.read(file.toString(), ScenarioSource.readFile(file));
    }

    /**
     * Reads one of the scenarios that ship with the program.
     *
     * @param name the file's name in the folder {@code scenarios}, such as {@code office.xml}
     * @return the scenario
     * @throws ScenarioException if there is none of that name
     */
    public static Scenario loadShipped(String name) throws ScenarioException {
        return ScenarioReader.read(name, ScenarioSource.readShipped(name));
    }

    /**
     * Writes a scenario file, whole or not at all. What was written has been read back and found equal.
     *
     * @param file the file; one that exists is replaced
     * @throws IOException if it cannot be written, or the scenario holds what no file may
     */
    public void save(Path file) throws IOException {
        save(file, XmlComments.NONE);
    }

    /**
     * Writes a scenario file as {@link #save(RobotPath)}, with the comments that a person has put into it.
     *
     * @param file the file; one that exists is replaced
     * @param remarks the comments
     * @throws IOException if it cannot be written, or the scenario holds what no file may
     */
    public void save(Path file, XmlComments remarks) throws IOException {
        byte[] bytes = ScenarioWriter.toBytes(this, remarks);
        try (AtomicFile out = AtomicFile.create(file)) {
            out.stream().write(bytes);
            out.commit();
        }
    }

    /**
     * This scenario as a file, which has been read back and found equal.
     *
     * @return the file's bytes
     * @throws IOException if the scenario holds what no file may
     */
    public byte[] toBytes() throws IOException {
        return ScenarioWriter.toBytes(this, XmlComments.NONE);
    }

    /**
     * Runs this scenario to its duration and records it.
     *
     * @return the recorded run
     * @throws faultline.engine.RunFailedException if the run broke
     */
    public ScenarioRun run() {
        return ScenarioRun.execute(this, ControllerMode.DIRECT);
    }

    /**
     * This scenario with another setup, which is no record any more.
     *
     * @param other the setup
     * @return the same scenario otherwise
     */
    public Scenario withSetup(SimulationSetup other) {
        return new Scenario(name, description, recorded && other.equals(setup), other, expectation);
    }
}
