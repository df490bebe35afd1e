package faultline.scenario;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.io.XmlText;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.XmlComments;
import faultline.scenario.xml.XmlElement;
import java.io.IOException;
import java.nio.file.Path;

/**
 * A scenario: a setup, what its run is expected to give, and a name. A test needs three lines:
 *
 * <pre>{@code
 * ScenarioRun run = Scenario.load(Path.of("scenarios/office.xml")).run();
 * assertEquals(List.of(), run.unmetExpectations());
 * assertTrue(run.collision().isEmpty());
 * }</pre>
 *
 * @param name a name for people; on one line
 * @param description a description for people, may be empty; on one line
 * @param recorded whether this is the record of a run up to its duration, which the window replays
 * @param setup the setup of the run
 * @param expectation the expected result
 */
public record Scenario(
        String name, String description, boolean recorded, SimulationSetup setup, Expectation expectation) {

    /**
     * Creates a scenario, with the name and the description on one line each.
     *
     * @param name a name for people; on one line
     * @param description a description for people, may be empty; on one line
     * @param recorded whether this is the record of a run up to its duration, which the window replays
     * @param setup the setup of the run
     * @param expectation the expected result
     */
    public Scenario {
        name = XmlText.oneLine(name);
        description = XmlText.oneLine(description);
    }

    /**
     * {@return the scenario in a file}
     *
     * @param file the file
     * @throws ScenarioException with everything that is wrong with the file
     */
    public static Scenario load(Path file) throws ScenarioException {
        return ScenarioReader.read(file);
    }

    /**
     * {@return the scenario in a tree of elements}
     *
     * @param file the name of the file in problems
     * @param root the root element
     * @throws ScenarioException with everything that is wrong
     */
    public static Scenario read(String file, XmlElement root) throws ScenarioException {
        return ScenarioReader.read(file, root);
    }

    /**
     * {@return a scenario that is part of the program}
     *
     * @param name the name of a file in the folder {@code scenarios}, such as {@code office.xml}
     * @throws ScenarioException if there is none of that name
     */
    public static Scenario loadShipped(String name) throws ScenarioException {
        return ScenarioReader.readShipped(name);
    }

    /**
     * Writes a scenario file, completely or not at all.
     *
     * @param file the file; an existing one is replaced
     * @throws IOException if the file cannot be written, or the scenario is beyond the limits of the format
     */
    public void save(Path file) throws IOException {
        save(file, XmlComments.NONE);
    }

    /**
     * Writes a scenario file as {@link #save(Path)} does, with comments that a person has put into it.
     *
     * @param file the file; an existing one is replaced
     * @param comments the comments
     * @throws IOException if the file cannot be written, or the scenario is beyond the limits of the format
     */
    public void save(Path file, XmlComments comments) throws IOException {
        ScenarioWriter.write(this, file, comments);
    }

    /**
     * {@return the bytes of a file with this scenario}
     *
     * @throws IOException if the scenario is beyond the limits of the format
     */
    public byte[] toBytes() throws IOException {
        return ScenarioWriter.toBytes(this, XmlComments.NONE);
    }

    /**
     * {@return the run of this scenario to its duration, with a record of every tick}
     *
     * @throws faultline.engine.RunFailedException if the run failed
     */
    public ScenarioRun run() {
        return ScenarioRun.execute(this, ControllerMode.DIRECT);
    }

    /**
     * {@return this scenario with another name}
     *
     * @param other the name for people
     */
    public Scenario withName(String other) {
        return new Scenario(other, description, recorded, setup, expectation);
    }

    /**
     * {@return this scenario with another setup; unless the setup is equal, the result is not a record of a run}
     *
     * @param other the new setup
     */
    public Scenario withSetup(SimulationSetup other) {
        return new Scenario(name, description, recorded && other.equals(setup), other, expectation);
    }

    /**
     * {@return this scenario with another expectation}
     *
     * @param other the expected result of its run
     */
    public Scenario withExpectation(Expectation other) {
        return new Scenario(name, description, recorded, setup, other);
    }
}
