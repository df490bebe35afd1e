package faultline.paint;

import faultline.engine.Journal;
import faultline.engine.RecordedRun;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.util.List;
import java.util.OptionalLong;

/** Earlier runs to be painted. */
public final class SampleGhosts {

    private SampleGhosts() {
    }

    /** Twenty seconds of the office, with a divergence at ten. */
    public static Ghost ofTheOffice() {
        try {
            Scenario office = Scenario.shipped("office.xml");
            RecordedRun run = RecordedRun.of(new Journal(office.setup(), List.of(), 2000));
            return new Ghost(run, office.setup().dt(), OptionalLong.of(1000), List.of("Ghost: Office", "Differs from 10 s on"), "differs from 10 s");
        } catch (ScenarioException impossible) {
            throw new AssertionError("shipped", impossible);
        }
    }
}
