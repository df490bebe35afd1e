package faultline.gui.properties;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.scenario.Scenario;
import faultline.world.WorldSpec;

/**
 * The properties of a scenario besides its robot, its obstacles and its timeline.
 *
 * @param name the name
 * @param description the description
 * @param width the width of the world, metres
 * @param height the height of the world, metres
 * @param enclosed whether a wall encloses the world
 * @param start the initial pose of the robot
 * @param duration seconds
 * @param dt the length of a tick, seconds
 * @param seed the seed of all random numbers
 * @param expectation the expected result
 */
record ScenarioProperties(
        String name,
        String description,
        double width,
        double height,
        boolean enclosed,
        Pose start,
        double duration,
        double dt,
        long seed,
        Expectation expectation) {

    static ScenarioProperties of(Scenario scenario) {
        SimulationSetup setup = scenario.setup();
        WorldSpec world = setup.world();
        return new ScenarioProperties(
                scenario.name(),
                scenario.description(),
                world.width(),
                world.height(),
                world.enclosed(),
                setup.start(),
                setup.duration(),
                setup.dt(),
                setup.seed(),
                scenario.expectation());
    }

    /** Returns a scenario with these properties instead of its own. */
    Scenario applyTo(Scenario scenario) {
        SimulationSetup old = scenario.setup();
        WorldSpec world = new WorldSpec(
                width, height, enclosed, old.world().maxMoving(), old.world().obstacles());
        SimulationSetup setup =
                new SimulationSetup(world, old.robot(), start, old.controller(), old.timeline(), dt, seed, duration);
        return new Scenario(name, description, scenario.recorded() && setup.equals(old), setup, expectation);
    }
}
