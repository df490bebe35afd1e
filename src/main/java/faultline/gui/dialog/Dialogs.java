package faultline.gui.dialog;

import faultline.engine.RunFailedException;
import faultline.external.ControllerProblem;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.document.FileNames;
import faultline.gui.document.TaskKind;
import faultline.gui.properties.FloorPlanFiles;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.text.TextWrap;
import faultline.gui.theme.Glyph;
import faultline.io.ProgramVersion;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import java.awt.Component;
import java.awt.Font;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.ImageIcon;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;

/** The window's messages: failures, problems in a file, shortcuts and the about box. */
public final class Dialogs {

    private final Window owner;

    public Dialogs(Window owner) {
        this.owner = owner;
    }

    public void addTo(ActionRegistry actions) {
        actions.add(
                UiAction.of("shortcuts", () -> createShortcutsDialog(actions).setVisible(true))
                        .withAccelerator(Keystrokes.unmodified(KeyEvent.VK_F1)));
        actions.add(UiAction.of("guide", () -> GuideDialog.showGuide(owner)));
        actions.add(UiAction.of("about", this::showAbout));
    }

    /** Brings a dialog of the given class to the front and returns whether one is open. */
    public static boolean bringToFront(Window owner, Class<? extends Window> kind) {
        Optional<Window> open = Stream.of(owner.getOwnedWindows())
                .filter(kind::isInstance)
                .filter(Window::isShowing)
                .findFirst();
        open.ifPresent(Window::toFront);
        open.ifPresent(Window::requestFocus);
        return open.isPresent();
    }

    /**
     * Asks a question and returns the index of the chosen answer, or a negative number if the dialog was closed. Enter
     * chooses the first answer.
     */
    public static int ask(Component parent, String title, String question, String... answerKeys) {
        String[] answers = Stream.of(answerKeys).map(Messages::get).toArray(String[]::new);
        return JOptionPane.showOptionDialog(
                parent,
                TextWrap.wrap(question),
                title,
                JOptionPane.DEFAULT_OPTION,
                JOptionPane.QUESTION_MESSAGE,
                null,
                answers,
                answers[0]);
    }

    /** Shows the reason why a task failed, and whether the scenario that was open before is still open. */
    public void showFailure(TaskKind task, Path file, Throwable cause, boolean keepsScenario) {
        if (cause instanceof ScenarioException exception
                && exception.problems().stream()
                        .anyMatch(problem -> problem.location().line() > 0)) {
            createProblemsDialog(file, exception.problems(), keepsScenario).setVisible(true);
            return;
        }
        String sentence = TextWrap.wrap(failureText(task, file, cause));
        boolean opens = task == TaskKind.OPEN;
        String text =
                opens ? sentence + "\n" + Messages.get(keepsScenario ? "badFile.kept" : "badFile.example") : sentence;
        JOptionPane.showMessageDialog(
                owner, text, Messages.get(opens ? "badFile.title" : "failed.title"), JOptionPane.ERROR_MESSAGE);
    }

    /** Returns the sentence that says why a task failed. */
    static String failureText(TaskKind task, Path file, Throwable cause) {
        return Messages.get("failed." + task, FileNames.lastOf(file), reasonText(file, cause));
    }

    /** Returns the reason of a failure; what a controller wrote on standard error has its lines, as in a traceback. */
    private static String reasonText(Path file, Throwable cause) {
        if (cause instanceof RunFailedException failed && failed.reason().template() == ControllerProblem.LAST_LINES) {
            List<Object> parts = failed.reason().arguments();
            String before = ('\n' + parts.get(2).toString()).replace(" | ", "\n");
            return Messages.get(ControllerProblem.LAST_LINES.with(parts.get(0), parts.get(1), before));
        }
        return ErrorMessages.describe(cause, file);
    }

    /** Shows why the chosen controller does not start, so that a scenario opens with its own. */
    public void showControllerFailure(Path file, Throwable cause) {
        String text = Messages.get("chooseController.failed", FileNames.lastOf(file), reasonText(file, cause));
        showError(owner, text);
    }

    /** Shows why something has failed. */
    public static void showError(Component parent, String sentence) {
        showFailed(parent, sentence, JOptionPane.ERROR_MESSAGE);
    }

    /** Shows why something has failed or cannot be done, where the user can correct it and try again. */
    public static void showWarning(Component parent, String sentence) {
        showFailed(parent, sentence, JOptionPane.WARNING_MESSAGE);
    }

    private static void showFailed(Component parent, String sentence, int icon) {
        JOptionPane.showMessageDialog(parent, TextWrap.wrap(sentence), Messages.get("failed.title"), icon);
    }

    /** Returns the message for an open file that another program has made unreadable. */
    public static String unreadableFileText(ScenarioException exception) {
        Problem first = exception.problems().get(0);
        return Messages.get(
                "broken",
                FileNames.lastOf(Path.of(first.file())) + first.location().toString() + ": "
                        + Messages.get(first.message()));
    }

    private JDialog createProblemsDialog(Path file, List<Problem> problems, boolean keepsScenario) {
        List<List<String>> rows = problems.stream()
                .map(problem -> List.of(
                        positionText(problem.location().line()),
                        positionText(problem.location().column()),
                        Messages.get(problem.message())))
                .toList();
        List<TableDialog.DialogColumn> columns = List.of(
                new TableDialog.DialogColumn(Messages.get("badFile.line"), 60),
                new TableDialog.DialogColumn(Messages.get("badFile.column"), 70),
                new TableDialog.DialogColumn(Messages.get("badFile.problem"), 560));
        return new TableDialog(
                owner,
                Messages.get("badFile.title"),
                headingText(file, keepsScenario),
                UIManager.getIcon("OptionPane.errorIcon"),
                columns,
                rows);
    }

    /** Returns the sentences above the problems of a file. */
    static String headingText(Path file, boolean keepsScenario) {
        List<String> sentences = new ArrayList<>();
        sentences.add(Messages.get("badFile.heading", FileNames.lastOf(file)));
        if (FloorPlanFiles.isFloorPlan(file)) {
            sentences.add(Messages.get("badFile.floorPlan"));
        }
        if (isController(file)) {
            sentences.add(Messages.get("badFile.controller"));
        }
        sentences.add(Messages.get(keepsScenario ? "badFile.kept" : "badFile.example"));
        return String.join(" ", sentences);
    }

    /** Returns whether a file is a program in Python or a jar, by its name. */
    private static boolean isController(Path file) {
        String name = FileNames.lastOf(file).toLowerCase(Locale.ROOT);
        return name.endsWith(".py") || name.endsWith(".jar");
    }

    private static String positionText(int number) {
        return number > 0 ? Integer.toString(number) : "–";
    }

    private JDialog createShortcutsDialog(ActionRegistry actions) {
        List<List<String>> rows =
                ShortcutRows.of(SwingUtilities.getRootPane(owner).getJMenuBar(), actions);
        List<TableDialog.DialogColumn> columns = List.of(
                new TableDialog.DialogColumn(Messages.get("shortcuts.place"), 90),
                new TableDialog.DialogColumn(Messages.get("shortcuts.key"), 150),
                new TableDialog.DialogColumn(Messages.get("shortcuts.action"), 420));
        return new TableDialog(
                owner,
                Messages.get("shortcuts.title"),
                Keystrokes.withMenuModifier(Messages.get("shortcuts.heading")),
                Glyph.NOTE.icon(),
                columns,
                rows);
    }

    private void showAbout() {
        String version = ProgramVersion.find().orElse("–");
        Icon robot = new ImageIcon(AppIcon.createImage(64));
        JLabel name = new JLabel(Messages.get("about.name", version));
        name.setFont(name.getFont().deriveFont(Font.BOLD));
        Object[] message = {name, " ", Messages.get("about.text", System.getProperty("java.version"))};
        JOptionPane.showMessageDialog(
                owner, message, Messages.get("about.title"), JOptionPane.INFORMATION_MESSAGE, robot);
    }
}
