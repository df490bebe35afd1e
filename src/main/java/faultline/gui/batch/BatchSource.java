package faultline.gui.batch;

import faultline.scenario.Scenario;
import java.nio.file.Path;

/**
 * What a batch is made of. It stays the same when the window shows a run or another scenario.
 *
 * @param scenario the scenario
 * @param stem its file, or a file with its name if it has none, without the extension
 * @param reopen opens the scenario in the window again
 */
record BatchSource(Scenario scenario, Path stem, Runnable reopen) {

    /** Returns a file beside that of the scenario, with its name and an ending. */
    Path file(String ending) {
        return stem.resolveSibling(stem.getFileName() + ending);
    }
}
