package faultline.studies.figure;

import java.io.IOException;

/** A figure or study, which writes its own files. */
public interface Figure {

    /**
     * Writes the files.
     *
     * @param folder the target
     * @throws IOException if a file cannot be written
     */
    void write(FigureFolder folder) throws IOException;
}
