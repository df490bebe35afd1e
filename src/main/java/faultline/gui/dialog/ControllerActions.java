package faultline.gui.dialog;

import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.external.ControllerChoice;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.document.BackgroundPoll;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.settings.RecentTexts;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import java.awt.EventQueue;
import java.awt.Window;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import javax.swing.Timer;

/**
 * The actions that choose a controller for the runs of the window, or for a ghost: the scenario's own, one in Java, or
 * a command. Each restart loads it again, and a note says when one of its files has changed.
 */
public final class ControllerActions implements WorkspaceListener, AutoCloseable {

    private static final int WATCH_MILLIS = 1000;

    private final Window owner;
    private final Workspace workspace;
    private final RunController runController;
    private final ComparisonController comparison;
    private final Notes notes;
    private final RecentTexts recentCommands;
    private final ErrorLines errorLines;

    private final UiAction scenarioController = UiAction.of("scenarioController", this::returnToScenarios);
    private final Timer watch = new Timer(WATCH_MILLIS, event -> checkFiles());
    /** What the dialog shows. */
    private ControllerChoice choice = ControllerChoice.SCENARIO;
    /** The controller of the next session. */
    private ControllerChoice next = ControllerChoice.SCENARIO;
    /** The controller of the session. */
    private ControllerChoice started = ControllerChoice.SCENARIO;
    /** Returns to the controller before the last choice; null if it was for good, or a session has started since. */
    private Runnable restore;
    /** Whether the controller of the last task has been given up with it. */
    private boolean givenUp;

    private ControllerChoice ghostChoice = ControllerChoice.SCENARIO;
    /** Whether the ghost starts with the next session. */
    private boolean ghostPending;

    /** Reads the times of the files of the session's controller. */
    private BackgroundPoll poll = new BackgroundPoll();
    /** The times of the files that the controller of the session was loaded from. */
    private Map<Path, FileTime> files = Map.of();
    /** The file that has changed last, null if none has changed since the controller was loaded. */
    private Path changedFile;
    /** The note about it, empty if there is none. */
    private String changedNote = "";

    /** Creates the actions for the runs of a workspace, which offers the commands that were used last. */
    public ControllerActions(
            Window owner,
            Workspace workspace,
            RunController runController,
            ComparisonController comparison,
            Notes notes,
            RecentTexts recentCommands) {
        this.owner = owner;
        this.workspace = workspace;
        this.runController = runController;
        this.comparison = comparison;
        this.notes = notes;
        this.recentCommands = recentCommands;
        this.errorLines = new ErrorLines(notes);
        scenarioController.setEnabled(false);
        workspace.addListener(this);
    }

    /** Adds the actions that choose the controller of the run, the scenario's own one, and that of a ghost. */
    public void addTo(ActionRegistry actions) {
        actions.add(UiAction.of(
                "chooseController", () -> ask("chooseController", choice).ifPresent(this::tryOut)));
        actions.add(scenarioController);
        actions.add(UiAction.of(
                "compareController", () -> ask("compareController", ghostChoice).ifPresent(chosen -> {
                    ghostChoice = chosen;
                    startGhost();
                })));
    }

    private void startGhost() {
        ControllerChoice chosen = ghostChoice;
        comparison.compareWith(chosen, errorLines.forGhost(), setup -> remember(chosen, setup));
    }

    private void returnToScenarios() {
        tryOut(new ControllerChoice("", choice.jars()));
    }

    /** Returns the name or the command of the controller that the user has chosen for the run; empty for none. */
    public String chosenText() {
        return started.text();
    }

    /** Returns the controller that drives the robot of the open scenario. */
    public ControllerChoice chosen() {
        return started;
    }

    /** Returns whether that controller is a command, which starts a program. */
    public boolean startsProgram() {
        return workspace.session().stream().anyMatch(session -> ControllerChoice.startsCommand(session.setup()));
    }

    /** Returns the jars with controllers that the user has added. */
    public List<Path> jars() {
        return choice.jars();
    }

    private Optional<ControllerChoice> ask(String key, ControllerChoice now) {
        return new ControllerDialog(key, now, workspace.file().orElse(null), recentCommands.texts()).showDialog(owner);
    }

    /** Restarts the run with a controller, which is also that of later runs if it can be started. */
    void tryOut(ControllerChoice chosen) {
        selectUnlessGivenUp(chosen, chosen);
        runController.restart();
    }

    /** Selects the controller of a scenario that is opened now, and of all later sessions if that succeeds. */
    public void selectForOpening(ControllerChoice chosen) {
        selectUnlessGivenUp(chosen, choice);
    }

    /**
     * Selects the controller of the next session and all later ones. If there is no next session, the one before is
     * selected again; the dialog then shows {@code shownOtherwise}.
     */
    private void selectUnlessGivenUp(ControllerChoice chosen, ControllerChoice shownOtherwise) {
        Runnable earlier = restore == null ? () -> {} : restore;
        ControllerChoice before = next;
        Runnable inWorkspace = use(chosen);
        choice = chosen;
        restore = () -> {
            next = before;
            inWorkspace.run();
            earlier.run();
            choice = shownOtherwise;
        };
    }

    /** Selects the controller of the next session and all later ones. */
    void select(ControllerChoice chosen) {
        choice = chosen;
        restore = null;
        givenUp = false;
        use(chosen);
    }

    /** Uses a controller for the next session and all later ones; returns what uses the one before again. */
    private Runnable use(ControllerChoice chosen) {
        next = chosen;
        return workspace.setControllerChoice((setup, scenarioName) -> {
            assert !EventQueue.isDispatchThread();
            return chosen.applyTo(setup, scenarioName, errorLines.forNewController());
        });
    }

    /** Selects the controllers of the scenario that is opened next and of a ghost beside it, null for none. */
    public void select(ControllerChoice chosen, ControllerChoice ghostOrNull) {
        select(chosen);
        ghostPending = ghostOrNull != null;
        if (ghostPending) {
            ghostChoice = ghostOrNull;
        }
    }

    /**
     * Called when a scenario could not be opened. If the controller of all sessions could not be started, this opens
     * the scenario with its own controller instead and returns true; the dialog still shows the choice.
     */
    public boolean openFailed(Throwable cause) {
        if (cause instanceof RunFailedException && !givenUp && !next.isScenarioDefault()) {
            use(ControllerChoice.SCENARIO);
            workspace.retry();
            return true;
        }
        ghostPending = false;
        return false;
    }

    /** With a controller that cannot be started, no scenario could be opened; the dialog still shows it. */
    @Override
    public void taskFinished() {
        givenUp = restore != null;
        if (givenUp) {
            restore.run();
            restore = null;
        }
    }

    @Override
    public void sessionStarted() {
        errorLines.controllerStarted();
        restore = null;
        ControllerChoice before = started;
        started = workspace.keepsController() ? ControllerChoice.SCENARIO : next;
        scenarioController.setEnabled(!started.isScenarioDefault());
        if (ghostPending) {
            ghostPending = false;
            startGhost();
        }
        watch.stop();
        // The restart has loaded a changed file.
        files = Map.of();
        poll = new BackgroundPoll();
        changedFile = null;
        updateTexts();
        ControllerChoice chosen = started;
        if (!chosen.isScenarioDefault()) {
            BackgroundTasks.compute(
                    () -> times(chosen.files()),
                    found -> {
                        if (chosen.equals(started)) {
                            files = found;
                            watch.start();
                        }
                    },
                    failure -> {});
            if (!chosen.equals(before)) {
                workspace.session().ifPresent(session -> remember(chosen, session.setup()));
            }
        }
    }

    /** Adds a controller to the recent commands if it is one, given the setup of a run that it has been started for. */
    private void remember(ControllerChoice chosen, SimulationSetup setup) {
        if (ControllerChoice.startsCommand(setup)) {
            recentCommands.add(chosen.text());
        }
    }

    @Override
    public void decidedDifferently(double time) {
        notes.show(Messages.get("chooseController.differs", NumberText.format("%.2f", time)));
    }

    /** Stops watching the files of the controller. Called when the window is closed. */
    @Override
    public void close() {
        started = ControllerChoice.SCENARIO;
        watch.stop();
    }

    /** Returns the lines that the controllers of the run and of ghosts have printed since the last call. */
    public List<String> takePrintedLines() {
        return errorLines.takeNew();
    }

    /** Returns whether changes of the files of the session's controller are noted. */
    boolean isWatching() {
        return watch.isRunning();
    }

    /** Checks in the background whether a file of the session's controller has changed. */
    void checkFiles() {
        ControllerChoice chosen = started;
        poll.compute(() -> times(chosen.files()), newCheck(), failure -> {});
    }

    /**
     * Returns what compares the times of the files when they are known, unless a restart has loaded the files again.
     */
    Consumer<Map<Path, FileTime>> newCheck() {
        Map<Path, FileTime> before = files;
        return now -> {
            if (files == before) {
                compare(now);
            }
        };
    }

    private void compare(Map<Path, FileTime> now) {
        now.forEach((file, time) -> {
            if (files.containsKey(file) && !time.equals(files.get(file))) {
                changedFile = file;
                updateTexts();
            }
        });
        // A file that a build has deleted keeps its old time until it is there again.
        Map<Path, FileTime> known = new TreeMap<>(files);
        known.putAll(now);
        files = known;
    }

    /** Updates the note about a changed file, also to the current language. */
    public void updateTexts() {
        notes.remove(changedNote);
        changedNote = changedFile == null
                ? ""
                : Messages.get(
                        "chooseController.changed", changedFile.getFileName().toString());
        if (changedFile != null) {
            notes.keep(changedNote);
        }
    }

    private static Map<Path, FileTime> times(List<Path> files) {
        Map<Path, FileTime> times = new TreeMap<>();
        for (Path file : files) {
            try {
                times.put(file, Files.getLastModifiedTime(file));
            } catch (IOException notThere) {
                // The file is being written.
            }
        }
        return times;
    }
}
