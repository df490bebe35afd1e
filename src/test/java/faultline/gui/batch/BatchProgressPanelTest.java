package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.ComponentFinder;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class BatchProgressPanelTest {

    private final BatchProgressPanel panel = callOnEdt(BatchProgressPanel::new);

    @AfterEach
    void restoreLanguage() {
        runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
    }

    private String status() {
        return callOnEdt(() -> ComponentFinder.findAll(panel, JLabel.class)
                .findFirst()
                .orElseThrow()
                .getText());
    }

    /** The runs are counted several times per second. */
    @Test
    void aPlanThatIsSavedDuringABatchIsMentionedUntilItsEnd() {
        runOnEdt(() -> {
            panel.begin();
            panel.showSaved("plan.xml");
            panel.show(new BatchRun.Completion(2, 10, 4), true);
        });
        assertEquals("2 of 10 runs, 16 s left. Saved as plan.xml", status());
        runOnEdt(() -> {
            panel.end();
            panel.showStatus(() -> "Done");
        });
        assertEquals("Done", status());
        runOnEdt(() -> panel.showSaved("results"));
        assertEquals("Done. Saved as results", status());
        runOnEdt(() -> {
            Messages.setLanguage(Language.POLISH);
            ComponentFinder.tree(panel).forEach(RefreshSteps::run);
        });
        assertEquals("Done. Zapisano jako results", status());
    }

    @Test
    void aPlanThatIsSavedBeforeABatchIsMentionedAlone() {
        runOnEdt(() -> panel.showSaved("plan.xml"));
        assertEquals("Saved as plan.xml", status());
        runOnEdt(() -> {
            panel.begin();
            panel.showStatus(() -> "Checking");
        });
        assertEquals("Checking", status());
    }
}
