package faultline.gui.batch;

import faultline.campaign.run.CampaignRunner;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;

/** Shows how much of a batch has been made, and a sentence about it. */
final class BatchProgressPanel extends JPanel {

    private static final int STEPS = 1000;

    private final JProgressBar bar = new JProgressBar(0, STEPS);
    private final JLabel status = new JLabel(" ");
    private final JLabel controllers = new JLabel();
    private transient List<String> types = List.of();
    /** Returns the status in the current language. */
    private transient Supplier<String> statusText = () -> " ";
    /** The name of the file or folder that was saved last; null if none since work has begun or ended. */
    private transient String saved;

    BatchProgressPanel() {
        super(new BorderLayout(12, 0));
        UiText.name(bar, "batch.progress");
        add(bar, BorderLayout.CENTER);
        JPanel texts = new JPanel(new BorderLayout(12, 0));
        texts.add(RefreshSteps.add(status, label -> showStatus()), BorderLayout.CENTER);
        texts.add(RefreshSteps.add(controllers, label -> showControllers(types)), BorderLayout.LINE_END);
        add(texts, BorderLayout.SOUTH);
    }

    /** Hides the bar, where there is nothing to make. */
    void hideBar() {
        bar.setVisible(false);
    }

    /** Shows which controllers drove the robots, given their types in scenario files; none without results. */
    void showControllers(List<String> newTypes) {
        types = newTypes;
        String names = newTypes.stream().map(BatchControllerItem::nameOf).collect(Collectors.joining(", "));
        controllers.setText(newTypes.isEmpty() ? "" : Messages.get("batch.drivenBy", names));
    }

    /** Shows a sentence, given what returns it in the current language. */
    void showStatus(Supplier<String> text) {
        statusText = text;
        showStatus();
    }

    /** Shows the sentence, which a narrow window may cut, in a tip, too. */
    private void showStatus() {
        String text = statusText.get();
        if (saved != null) {
            String savedText = Messages.get("saved", saved);
            text = text.isBlank() ? savedText : Messages.get("batch.saved", text, savedText);
        }
        status.setText(text);
        status.setToolTipText(text.isBlank() ? null : text);
    }

    /** Shows behind the sentence that a file or folder has been saved, until work begins or ends. */
    void showSaved(String name) {
        saved = name;
        showStatus();
    }

    /** Shows that work of unknown length has begun. */
    void begin() {
        saved = null;
        bar.setIndeterminate(true);
    }

    /** Shows that no work is being done. */
    void end() {
        saved = null;
        bar.setIndeterminate(false);
    }

    /** Shows how many runs have been made; in words, too, if others are being made. */
    void show(BatchRun.Completion completion, boolean active) {
        bar.setIndeterminate(false);
        bar.setValue((int) (STEPS * completion.made() / Math.max(1, completion.runs())));
        if (active) {
            showStatus(() -> progressText(completion));
        }
    }

    /**
     * Returns how many runs a batch has made that has ended, and how many of them repeat another one.
     *
     * @param seconds the time that they took
     * @param repeats the number of runs that repeat an earlier one with another seed
     */
    static String endText(CampaignRunner.RunCounts counts, double seconds, long repeats) {
        String text = Messages.get(
                counts.isComplete() ? "batch.done" : "batch.cancelled",
                Long.toString(counts.made()),
                Long.toString(counts.runs()),
                Long.toString(counts.broken()),
                DurationText.text(seconds));
        return withRepeats(text, repeats);
    }

    /** Returns how many runs of a campaign have been read, and how many of them repeat another one. */
    static String openedText(long opened, long runs, long broken, long repeats) {
        String text = Messages.get(
                opened == runs ? "batch.opened.all" : "batch.opened.part",
                Long.toString(opened),
                Long.toString(runs),
                Long.toString(broken));
        return withRepeats(text, repeats);
    }

    private static String withRepeats(String text, long repeats) {
        return repeats == 0 ? text : Messages.get("batch.repeats", text, Long.toString(repeats));
    }

    /** Returns how many runs have been made, and the time for the others unless it is not known yet. */
    static String progressText(BatchRun.Completion completion) {
        String made = Long.toString(completion.made());
        String runs = Long.toString(completion.runs());
        return Double.isNaN(completion.secondsLeft())
                ? Messages.get("batch.begun", made, runs)
                : Messages.get("batch.status", made, runs, DurationText.text(completion.secondsLeft()));
    }
}
