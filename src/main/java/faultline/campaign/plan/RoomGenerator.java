package faultline.campaign.plan;

import faultline.campaign.RandomRoom;
import faultline.campaign.RoomRules;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.scenario.xml.ScenarioContent;

/** Makes the scenario of a random room: the default robot and follower in it. */
final class RoomGenerator {

    private RoomGenerator() {}

    static ScenarioContent room(String name, long seed, RoomRules rules) {
        RandomRoom room = RandomRoom.ofSeed(seed, rules);
        SimulationSetup setup = SimulationSetup.of(room.world(), room.start());
        return new ScenarioContent(name, "", false, setup, Expectation.NONE);
    }
}
