package faultline.gui.properties;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.scenario.Scenario;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;

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

    /**
     * Returns a scenario with those of these properties that differ from earlier ones, which were those of the edited
     * scenario. The scenario may expect states that the edited one hides, because no controller of its run has them.
     */
    Scenario applyChanges(ScenarioProperties before, Scenario scenario) {
        ScenarioProperties old = of(scenario);
        return new ScenarioProperties(
                        changed(before.name, name, old.name),
                        changed(before.description, description, old.description),
                        changed(before.width, width, old.width),
                        changed(before.height, height, old.height),
                        changed(before.enclosed, enclosed, old.enclosed),
                        changed(before.start, start, old.start),
                        changed(before.duration, duration, old.duration),
                        changed(before.dt, dt, old.dt),
                        changed(before.seed, seed, old.seed),
                        withHidden(before.expectation, expectation, old.expectation))
                .applyTo(scenario);
    }

    private static <T> T changed(T before, T after, T old) {
        return after.equals(before) ? old : after;
    }

    /** Returns the expectation after a change, with the old conditions that the one before it did not have. */
    private static Expectation withHidden(Expectation before, Expectation after, Expectation old) {
        if (after.equals(before)) {
            return old;
        }
        List<Expectation.Condition> hidden = new ArrayList<>(old.conditions());
        hidden.removeAll(before.conditions());
        List<Expectation.Condition> conditions = new ArrayList<>(after.conditions());
        for (Expectation.Condition condition : hidden) {
            if (!isFinal(condition)) {
                conditions.add(placeOf(condition, old.conditions(), conditions), condition);
            } else if (after.conditions().stream().noneMatch(ScenarioProperties::isFinal)) {
                conditions.add(condition);
            }
        }
        return new Expectation(conditions);
    }

    /** Returns where a hidden state belongs: after the old state before it, else before the next one that is left. */
    private static int placeOf(
            Expectation.Condition hidden, List<Expectation.Condition> old, List<Expectation.Condition> conditions) {
        List<Expectation.Condition> left = new ArrayList<>(old);
        left.removeIf(condition -> condition.getClass() != hidden.getClass()
                || !condition.equals(hidden) && !conditions.contains(condition));
        int index = left.indexOf(hidden);
        if (index > 0) {
            return conditions.indexOf(left.get(index - 1)) + 1;
        }
        if (index + 1 < left.size()) {
            return conditions.indexOf(left.get(index + 1));
        }
        return (int)
                conditions.stream().filter(condition -> !isFinal(condition)).count();
    }

    private static boolean isFinal(Expectation.Condition condition) {
        return condition instanceof Expectation.FinalState;
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
