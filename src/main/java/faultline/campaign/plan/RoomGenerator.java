package faultline.campaign.plan;

import faultline.campaign.RandomRoom;
import faultline.campaign.RoomRules;
import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.ScenarioContent;
import java.util.List;

/** Makes the scenario of a random room: the default robot and follower in it. */
final class RoomGenerator {

    private RoomGenerator() {}

    static ScenarioContent room(String name, long seed, RoomRules rules) {
        RandomRoom room = RandomRoom.ofSeed(seed, rules);
        SimulationSetup setup = new SimulationSetup(
                room.world(),
                RobotSpec.DEFAULT,
                room.start(),
                ControllerSpec.WallFollowing.DEFAULT,
                List.of(),
                ScenarioContent.DEFAULT_TICK,
                ScenarioContent.DEFAULT_SEED,
                ScenarioContent.DEFAULT_DURATION);
        return new ScenarioContent(name, "", false, setup, Expectation.NONE);
    }
}
