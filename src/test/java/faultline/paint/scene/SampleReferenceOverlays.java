package faultline.paint.scene;

import faultline.engine.Journal;
import faultline.engine.session.ReferenceRun;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.util.List;

/** Reference runs for tests of painters. */
public final class SampleReferenceOverlays {

    private SampleReferenceOverlays() {}

    /** Twenty seconds of the office, with a divergence at ten. */
    public static ReferenceOverlay office() {
        try {
            Scenario office = Scenario.loadShipped("office.xml");
            ReferenceRun run = ReferenceRun.replay(new Journal(office.setup(), List.of(), 2000), tick -> true);
            return new ReferenceOverlay(
                    run,
                    List.of("Ghost: Office", "Differs from 10 s on"),
                    List.of(new ReferenceOverlay.Mark(1000, "differs from 10 s")));
        } catch (ScenarioException impossible) {
            throw new AssertionError("shipped", impossible);
        }
    }
}
