package faultline.studies.figure;

import java.io.IOException;

/** A figure or study, which writes its own files. */
public interface Figure {

    /** Writes the files. */
    void write(FigureFolder folder) throws IOException;
}
