<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- Texts of the rooms below the window: src/viewer/language/core_words.h says how they are looked up. -->
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>keys</name>
    <message>
        <source>Left drag, arrows</source>
        <translation>Links ziehen, Pfeile</translation>
    </message>
    <message>
        <source>Walk around the patient</source>
        <translation>Um den Patienten herumgehen</translation>
    </message>
    <message>
        <source>Middle drag, Shift + left drag, Shift + arrows</source>
        <translation>Mitte ziehen, Umschalt + links ziehen, Umschalt + Pfeile</translation>
    </message>
    <message>
        <source>Move sideways</source>
        <translation>Seitwärts verschieben</translation>
    </message>
    <message>
        <source>Wheel, right drag, Ctrl + left drag, + and -</source>
        <translation>Rad, rechts ziehen, Strg + links ziehen, + und -</translation>
    </message>
    <message>
        <source>Closer, farther</source>
        <translation>Näher, weiter weg</translation>
    </message>
    <message>
        <source>Right drag in maximum, minimum, average</source>
        <translation>Rechts ziehen in Maximum, Minimum, Mittelwert</translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up</source>
        <translation>Fensterung: nach rechts breiter, nach oben heller</translation>
    </message>
    <message>
        <source>Double click in 3D</source>
        <translation>Doppelklick in 3D</translation>
    </message>
    <message>
        <source>Turn around what is there, and show it on slices</source>
        <translation>Um das drehen, was dort ist, und es auf Schichten zeigen</translation>
    </message>
    <message>
        <source>Window of the series again</source>
        <translation>Wieder die Fensterung der Serie</translation>
    </message>
    <message>
        <source>Look from anterior</source>
        <translation>Ansicht von anterior</translation>
    </message>
    <message>
        <source>Look from posterior</source>
        <translation>Ansicht von posterior</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation>Ansicht von links des Patienten</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation>Ansicht von rechts des Patienten</translation>
    </message>
    <message>
        <source>Look from superior</source>
        <translation>Ansicht von superior</translation>
    </message>
    <message>
        <source>Look from inferior</source>
        <translation>Ansicht von inferior</translation>
    </message>
    <message>
        <source>Fit what is visible</source>
        <translation>Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Patient, study and series over the picture, or not</source>
        <translation>Patient, Studie und Serie über dem Bild, oder nicht</translation>
    </message>
    <message>
        <source>Ctrl+1 to Ctrl+6</source>
        <translation>Strg+1 bis Strg+6</translation>
    </message>
    <message>
        <source>Cinematic, clear, ray cast, maximum, minimum, average</source>
        <translation>Cinematic, Klar, Volumen-Rendering, Maximum, Minimum, Mittelwert</translation>
    </message>
    <message>
        <source>Shade the ray cast, or not</source>
        <translation>Volumen-Rendering schattieren, oder nicht</translation>
    </message>
    <message>
        <source>Remove the table of a CT, or show it again</source>
        <translation>Den Tisch eines CT entfernen oder wieder zeigen</translation>
    </message>
    <message>
        <source>No clip</source>
        <translation>Kein Beschnitt</translation>
    </message>
    <message>
        <source>Drop a folder or a file</source>
        <translation>Ordner oder Datei ablegen</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Open an image or a volume file</source>
        <translation>Bild oder Volumendatei öffnen</translation>
    </message>
    <message>
        <source>Save the view: all that was chosen, and the camera</source>
        <translation>Ansicht speichern: alles, was gewählt wurde, und die Kamera</translation>
    </message>
    <message>
        <source>Open a view that was saved</source>
        <translation>Gespeicherte Ansicht öffnen</translation>
    </message>
    <message>
        <source>Save the picture, at any size</source>
        <translation>Bild speichern, in jeder Größe</translation>
    </message>
    <message>
        <source>Save the measurements as a table</source>
        <translation>Messungen als Tabelle speichern</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Letzte Änderung rückgängig</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>F5 to F9</source>
        <translation>F5 bis F9</translation>
    </message>
    <message>
        <source>Four panes, or 3D, axial, coronal, sagittal alone</source>
        <translation>Vier Bildfelder, oder 3D, axial, koronar, sagittal allein</translation>
    </message>
    <message>
        <source>F2 to F4</source>
        <translation>F2 bis F4</translation>
    </message>
    <message>
        <source>Panels: studies, transfer function, clip</source>
        <translation>Leisten: Studien, Übertragungsfunktion, Beschnitt</translation>
    </message>
    <message>
        <source>Find a study of the folder</source>
        <translation>Studie des Ordners suchen</translation>
    </message>
    <message>
        <source>Wheel, Up, Down on slices</source>
        <translation>Rad, Auf, Ab auf Schichten</translation>
    </message>
    <message>
        <source>Next slice; with Shift, or Page Up and Page Down, five; Home and End: to the ends</source>
        <translation>Nächste Schicht; mit Umschalt oder Bild auf und Bild ab fünf; Pos1 und Ende: zu den Enden</translation>
    </message>
    <message>
        <source>Right drag, 1 to 9 on slices</source>
        <translation>Rechts ziehen, 1 bis 9 auf Schichten</translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up; or a customary one</source>
        <translation>Fensterung: nach rechts breiter, nach oben heller; oder eine übliche</translation>
    </message>
    <message>
        <source>Ctrl + wheel, middle drag, +, - on slices</source>
        <translation>Strg + Rad, Mitte ziehen, +, - auf Schichten</translation>
    </message>
    <message>
        <source>Closer, sideways</source>
        <translation>Näher, seitwärts</translation>
    </message>
    <message>
        <source>C, W, Z, M, D, G, E, V</source>
        <translation>C, W, Z, M, D, G, E, V</translation>
    </message>
    <message>
        <source>Left button on slices: cross-hair, window, zoom, move, distance, angle, ellipse, probe</source>
        <translation>Linke Taste auf Schichten: Fadenkreuz, Fensterung, Zoom, Verschieben, Strecke, Winkel, Ellipse, Messpunkt</translation>
    </message>
    <message>
        <source>I on slices</source>
        <translation>I auf Schichten</translation>
    </message>
    <message>
        <source>White and black change places</source>
        <translation>Weiß und Schwarz tauschen den Platz</translation>
    </message>
    <message>
        <source>Space on slices</source>
        <translation>Leertaste auf Schichten</translation>
    </message>
    <message>
        <source>Play through all slices, or stop</source>
        <translation>Alle Schichten abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Delete on slices</source>
        <translation>Entf auf Schichten</translation>
    </message>
    <message>
        <source>Remove the measurement that is chosen</source>
        <translation>Die gewählte Messung entfernen</translation>
    </message>
    <message>
        <source>Double click on slices</source>
        <translation>Doppelklick auf Schichten</translation>
    </message>
    <message>
        <source>This pane alone, or all four</source>
        <translation>Dieses Bildfeld allein, oder alle vier</translation>
    </message>
    <message>
        <source>Settings: language, look, keys, what is kept</source>
        <translation>Einstellungen: Sprache, Aussehen, Tasten, was aufbewahrt wird</translation>
    </message>
    <message>
        <source>All keys</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>&amp;Four Panes</source>
        <translation>&amp;Vier Bildfelder</translation>
    </message>
    <message>
        <source>&amp;3D Alone</source>
        <translation>&amp;3D allein</translation>
    </message>
    <message>
        <source>A&amp;xial Alone</source>
        <translation>A&amp;xial allein</translation>
    </message>
    <message>
        <source>C&amp;oronal Alone</source>
        <translation>K&amp;oronar allein</translation>
    </message>
    <message>
        <source>Sa&amp;gittal Alone</source>
        <translation>Sa&amp;gittal allein</translation>
    </message>
</context>
<context>
    <name>titles</name>
    <message>
        <source>Cinematic</source>
        <translation>Cinematic</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Klar</translation>
    </message>
    <message>
        <source>Ray cast</source>
        <translation>Volumen-Rendering</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source>Average (X-ray)</source>
        <translation>Mittelwert (Röntgen)</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>Cinematic MR</source>
        <translation>Cinematic MR</translation>
    </message>
    <message>
        <source>Cinematic bone</source>
        <translation>Cinematic Knochen</translation>
    </message>
    <message>
        <source>Cinematic chest</source>
        <translation>Cinematic Thorax</translation>
    </message>
    <message>
        <source>Cinematic lung</source>
        <translation>Cinematic Lunge</translation>
    </message>
    <message>
        <source>Cinematic soft tissue</source>
        <translation>Cinematic Weichteile</translation>
    </message>
    <message>
        <source>Cinematic vessels</source>
        <translation>Cinematic Gefäße</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Stirnlicht</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Gegenlicht</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>A ball in the middle</source>
        <translation>Eine Kugel in der Mitte</translation>
    </message>
    <message>
        <source>Axial slab through the middle, a tenth of the height</source>
        <translation>Axialer Slab durch die Mitte, ein Zehntel der Höhe</translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts</source>
        <translation>Linkes oberes vorderes Achtel herausgenommen, mit den Schichten auf den Schnitten</translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts, air black</source>
        <translation>Linkes oberes vorderes Achtel herausgenommen, mit den Schichten auf den Schnitten, Luft schwarz</translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut</source>
        <translation>Von vorn geöffnet, mit der Schicht auf dem Schnitt</translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut, air black</source>
        <translation>Von vorn geöffnet, mit der Schicht auf dem Schnitt, Luft schwarz</translation>
    </message>
    <message>
        <source>The back half</source>
        <translation>Die hintere Hälfte</translation>
    </message>
    <message>
        <source>The front half</source>
        <translation>Die vordere Hälfte</translation>
    </message>
    <message>
        <source>The lower half</source>
        <translation>Die untere Hälfte</translation>
    </message>
    <message>
        <source>The patient&apos;s left half</source>
        <translation>Die linke Hälfte des Patienten</translation>
    </message>
    <message>
        <source>The patient&apos;s right half</source>
        <translation>Die rechte Hälfte des Patienten</translation>
    </message>
    <message>
        <source>The upper half</source>
        <translation>Die obere Hälfte</translation>
    </message>
    <message>
        <source>Own clip</source>
        <translation>Eigener Beschnitt</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>bearbeitet</translation>
    </message>
</context>
<context>
    <name>dicom</name>
    <message>
        <source>Copy the whole series again from its source.</source>
        <translation>Kopieren Sie die ganze Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Copy the file again from its source.</source>
        <translation>Kopieren Sie die Datei noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Choose another series.</source>
        <translation>Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>Look at these images by themselves, or copy the series again from its source.</source>
        <translation>Sehen Sie sich diese Bilder einzeln an, oder kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Export the series again, or choose another.</source>
        <translation>Exportieren Sie die Serie noch einmal, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>No file of this series can be read; it has %1.</source>
        <translation>Keine Datei dieser Serie kann gelesen werden; sie hat %1.</translation>
    </message>
    <message>
        <source>A file cannot be opened.</source>
        <translation>Eine Datei kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation>Prüfen Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>A file is listed in the folder, and its content is not on this machine.</source>
        <translation>Eine Datei steht im Ordner, aber ihr Inhalt ist nicht auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Connect the drive, or make the files available offline.</source>
        <translation>Verbinden Sie das Laufwerk, oder machen Sie die Dateien offline verfügbar.</translation>
    </message>
    <message>
        <source>A DICOM file is damaged and cannot be read.</source>
        <translation>Eine DICOM-Datei ist beschädigt und kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>A DICOM file ends before its pixel data do.</source>
        <translation>Eine DICOM-Datei endet vor ihren Pixeldaten.</translation>
    </message>
    <message>
        <source>A DICOM image has no pixel data.</source>
        <translation>Ein DICOM-Bild hat keine Pixeldaten.</translation>
    </message>
    <message>
        <source>A DICOM image does not say in a number how many frames it has.</source>
        <translation>Ein DICOM-Bild sagt nicht mit einer Zahl, wie viele Einzelbilder es hat.</translation>
    </message>
    <message>
        <source>Frames that the files of this series should have, and that are not there: %1 of %2.</source>
        <translation>Einzelbilder, die die Dateien dieser Serie haben sollten und die fehlen: %1 von %2.</translation>
    </message>
    <message>
        <source>A few stray bytes follow the pixel data in some files; the images are whole.</source>
        <translation>In manchen Dateien folgen ein paar überzählige Bytes auf die Pixeldaten; die Bilder sind vollständig.</translation>
    </message>
    <message>
        <source>Files of this series that do not say what kind of object they are: %1.</source>
        <translation>Dateien dieser Serie, die nicht sagen, was für ein Objekt sie sind: %1.</translation>
    </message>
    <message>
        <source>Check that the series is what it seems to be.</source>
        <translation>Prüfen Sie, ob die Serie ist, was sie zu sein scheint.</translation>
    </message>
    <message>
        <source>Folders that could not be read: %1. Images in them are missing here.</source>
        <translation>Ordner, die nicht gelesen werden konnten: %1. Bilder darin fehlen hier.</translation>
    </message>
    <message>
        <source>Check the permissions of the folders, or copy the study again.</source>
        <translation>Prüfen Sie die Zugriffsrechte der Ordner, oder kopieren Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>Links that lead out of the chosen folder, and were not followed: %1.</source>
        <translation>Verknüpfungen, die aus dem gewählten Ordner führen und denen nicht gefolgt wurde: %1.</translation>
    </message>
    <message>
        <source>Choose the folder they lead to, if it is wanted.</source>
        <translation>Wählen Sie den Ordner, zu dem sie führen, wenn er gewünscht ist.</translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) lists and that are not there: %1.</source>
        <translation>Dateien, die das Verzeichnis dieses Mediums (DICOMDIR) aufführt und die fehlen: %1.</translation>
    </message>
    <message>
        <source>Copy the medium again; images may be missing.</source>
        <translation>Kopieren Sie das Medium noch einmal; Bilder können fehlen.</translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) names outside the chosen folder, and that were not read: %1.</source>
        <translation>Dateien, die das Verzeichnis dieses Mediums (DICOMDIR) außerhalb des gewählten Ordners nennt und die nicht gelesen wurden: %1.</translation>
    </message>
    <message>
        <source>Take care where this medium comes from.</source>
        <translation>Achten Sie darauf, woher dieses Medium kommt.</translation>
    </message>
    <message>
        <source>The directory of this medium (DICOMDIR) cannot be read; the files themselves were read.</source>
        <translation>Das Verzeichnis dieses Mediums (DICOMDIR) kann nicht gelesen werden; die Dateien selbst wurden gelesen.</translation>
    </message>
    <message>
        <source>Files that are copies of others of this series, and were left out: %1.</source>
        <translation>Dateien, die Kopien anderer dieser Serie sind und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Images that have the identifier of another of this series, in a file that differs: %1. Of each the first file is used; the others are in a stack of their own.</source>
        <translation>Bilder mit der Kennung eines anderen dieser Serie in einer abweichenden Datei: %1. Von jedem wird die erste Datei verwendet; die anderen liegen in einem eigenen Stapel.</translation>
    </message>
    <message>
        <source>Compare them before relying on this series.</source>
        <translation>Vergleichen Sie sie, bevor Sie sich auf diese Serie verlassen.</translation>
    </message>
    <message>
        <source>Files of this series that cannot be read, and were left out: %1.</source>
        <translation>Dateien dieser Serie, die nicht gelesen werden können und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Copy the series again from its source.</source>
        <translation>Kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Text of this series does not fit the character set it declares; names may be shown wrongly.</source>
        <translation>Text dieser Serie passt nicht zu ihrem angegebenen Zeichensatz; Namen können falsch gezeigt werden.</translation>
    </message>
    <message>
        <source>The files of this series name different patients or studies, and were split into %1 series.</source>
        <translation>Die Dateien dieser Serie nennen verschiedene Patienten oder Studien und wurden in %1 Serien geteilt.</translation>
    </message>
    <message>
        <source>Check name, ID, birth date and sex of the patient in every part; slices of this patient may lie in another part.</source>
        <translation>Prüfen Sie Name, ID, Geburtsdatum und Geschlecht des Patienten in jedem Teil; Schichten dieses Patienten können in einem anderen Teil liegen.</translation>
    </message>
    <message>
        <source>The images differ in %1, and were separated into %2 stacks.</source>
        <translation>Die Bilder unterscheiden sich in %1 und wurden in %2 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images have different sizes, and were separated into %1 stacks.</source>
        <translation>Die Bilder haben verschiedene Größen und wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>Some images are in colour and others are not; they were separated into %1 stacks.</source>
        <translation>Manche Bilder sind farbig und andere nicht; sie wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images lie in different orientations, and were separated into %1 stacks.</source>
        <translation>Die Bilder haben verschiedene Ausrichtungen und wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images do not share one coordinate system, or some have no position; they were separated into %1 stacks.</source>
        <translation>Die Bilder haben kein gemeinsames Koordinatensystem, oder manche haben keine Position; sie wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images have different pixel spacings, and were separated into %1 stacks.</source>
        <translation>Die Bilder haben verschiedene Pixelabstände und wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>Every position was imaged %1 times; each is a volume of its own, told apart by %2.</source>
        <translation>Jede Position wurde %1-mal aufgenommen; jede ist ein eigenes Volumen, unterschieden durch %2.</translation>
    </message>
    <message>
        <source>Every position was imaged %1 times, and only the order of the image numbers tells them apart.</source>
        <translation>Jede Position wurde %1-mal aufgenommen, und nur die Reihenfolge der Bildnummern unterscheidet sie.</translation>
    </message>
    <message>
        <source>Check that the volumes of this series are what they seem to be.</source>
        <translation>Prüfen Sie, ob die Volumen dieser Serie sind, was sie zu sein scheinen.</translation>
    </message>
    <message>
        <source>Phases that have fewer images than the others: %1 of %2.</source>
        <translation>Phasen, die weniger Bilder haben als die anderen: %1 von %2.</translation>
    </message>
    <message>
        <source>Images that lie at the same position as another: %1 of %2. Nothing in them says which belong together.</source>
        <translation>Bilder an derselben Position wie ein anderes: %1 von %2. Nichts darin sagt, welche zusammengehören.</translation>
    </message>
    <message>
        <source>Which images make a volume? Choose another series, or separate the files of this one by hand.</source>
        <translation>Welche Bilder ergeben ein Volumen? Wählen Sie eine andere Serie, oder trennen Sie die Dateien dieser von Hand.</translation>
    </message>
    <message>
        <source>Positions that were imaged more than once: %1. Of each, the image with the lowest number is in the volume, and the others are in a stack of their own.</source>
        <translation>Positionen, die mehrmals aufgenommen wurden: %1. Von jeder ist das Bild mit der kleinsten Nummer im Volumen, die anderen liegen in einem eigenen Stapel.</translation>
    </message>
    <message>
        <source>Compare the repeated images before relying on these slices.</source>
        <translation>Vergleichen Sie die wiederholten Bilder, bevor Sie sich auf diese Schichten verlassen.</translation>
    </message>
    <message>
        <source>Files of those that make up one image that are not here: %1 of %2.</source>
        <translation>Dateien, die zusammen ein Bild ergeben und hier fehlen: %1 von %2.</translation>
    </message>
    <message>
        <source>Series %1 of this study continues this stack, with the same slice distance.</source>
        <translation>Serie %1 dieser Studie setzt diesen Stapel mit demselben Schichtabstand fort.</translation>
    </message>
    <message>
        <source>Look at both; together they cover more.</source>
        <translation>Sehen Sie beide an; zusammen decken sie mehr ab.</translation>
    </message>
    <message>
        <source>This is a localizer: an overview image, not a slice of a volume.</source>
        <translation>Das ist ein Localizer: ein Übersichtsbild, keine Schicht eines Volumens.</translation>
    </message>
    <message>
        <source>Choose a series of slices.</source>
        <translation>Wählen Sie eine Serie von Schichten.</translation>
    </message>
    <message>
        <source>The slices are two even sets, shifted by %1 mm against each other, and nothing else tells them apart; each is a stack of its own.</source>
        <translation>Die Schichten sind zwei gleichmäßige Sätze, um %1 mm gegeneinander verschoben, und nichts sonst unterscheidet sie; jeder ist ein eigener Stapel.</translation>
    </message>
    <message>
        <source>Look at both; they may be two acquisitions.</source>
        <translation>Sehen Sie beide an; es können zwei Aufnahmen sein.</translation>
    </message>
    <message>
        <source>%1 changes along the slices, first at slice %2; values may step there.</source>
        <translation>%1 ändert sich entlang der Schichten, zuerst bei Schicht %2; dort können Werte springen.</translation>
    </message>
    <message>
        <source>Do not take a step there for a finding.</source>
        <translation>Halten Sie einen Sprung dort nicht für einen Befund.</translation>
    </message>
    <message>
        <source>Every other slice differs from those beside it in the same way: two acquisitions may be mixed in this volume.</source>
        <translation>Jede zweite Schicht weicht in gleicher Weise von ihren Nachbarn ab: in diesem Volumen können zwei Aufnahmen vermischt sein.</translation>
    </message>
    <message>
        <source>Compare the original images, slice by slice, before relying on this volume.</source>
        <translation>Vergleichen Sie die Originalbilder Schicht für Schicht, bevor Sie sich auf dieses Volumen verlassen.</translation>
    </message>
    <message>
        <source>The images lie in %1 blocks, up to %2 mm apart; each is a stack of its own, so what is shown is one of %3.</source>
        <translation>Die Bilder liegen in %1 Blöcken, bis zu %2 mm auseinander; jeder ist ein eigener Stapel, gezeigt wird also einer von %3.</translation>
    </message>
    <message>
        <source>Look at the other blocks too.</source>
        <translation>Sehen Sie auch die anderen Blöcke an.</translation>
    </message>
    <message>
        <source>Every image names a coordinate system (FrameOfReferenceUID) of its own, and together they make an even stack; it was taken for granted that they share one.</source>
        <translation>Jedes Bild nennt ein eigenes Koordinatensystem (FrameOfReferenceUID), und zusammen ergeben sie einen gleichmäßigen Stapel; es wurde angenommen, dass sie eines teilen.</translation>
    </message>
    <message>
        <source>Check that the slices fit each other. The series is not shown together with others.</source>
        <translation>Prüfen Sie, ob die Schichten zueinander passen. Die Serie wird nicht zusammen mit anderen gezeigt.</translation>
    </message>
    <message>
        <source>Images that name no coordinate system (FrameOfReferenceUID): %1 of %2. They continue the stack of the others, and it was taken for granted that they share theirs.</source>
        <translation>Bilder, die kein Koordinatensystem (FrameOfReferenceUID) nennen: %1 von %2. Sie setzen den Stapel der anderen fort, und es wurde angenommen, dass sie deren teilen.</translation>
    </message>
    <message>
        <source>Images that share one identifier (SOPInstanceUID) and lie at different positions: %1. All are kept.</source>
        <translation>Bilder, die eine Kennung (SOPInstanceUID) teilen und an verschiedenen Positionen liegen: %1. Alle bleiben.</translation>
    </message>
    <message>
        <source>Other programs may show only one of them; have the identifiers set right.</source>
        <translation>Andere Programme zeigen vielleicht nur eines davon; lassen Sie die Kennungen berichtigen.</translation>
    </message>
    <message>
        <source>Images that repeat another at the same position, pixel by pixel, and were left out: %1.</source>
        <translation>Bilder, die ein anderes an derselben Position Pixel für Pixel wiederholen und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Nothing is lost; the series was probably sent twice.</source>
        <translation>Nichts ist verloren; die Serie wurde wohl zweimal gesendet.</translation>
    </message>
    <message>
        <source>%1 images have a %2 identifier each and would make one even stack together.</source>
        <translation>%1 Bilder haben je eine eigene Kennung (%2) und ergäben zusammen einen gleichmäßigen Stapel.</translation>
    </message>
    <message>
        <source>Are they one series? Then open the folder with --join.</source>
        <translation>Sind sie eine Serie? Dann öffnen Sie den Ordner mit --join.</translation>
    </message>
    <message>
        <source>%1 images with a %2 identifier each were joined to this series because that was asked for.</source>
        <translation>%1 Bilder mit je einer eigenen Kennung (%2) wurden zu dieser Serie verbunden, weil das verlangt wurde.</translation>
    </message>
    <message>
        <source>Check that all of them are of one patient and one examination.</source>
        <translation>Prüfen Sie, ob alle von einem Patienten und einer Untersuchung sind.</translation>
    </message>
    <message>
        <source>There is only one slice.</source>
        <translation>Es gibt nur eine Schicht.</translation>
    </message>
    <message>
        <source>Choose a series with more slices.</source>
        <translation>Wählen Sie eine Serie mit mehr Schichten.</translation>
    </message>
    <message>
        <source>The images do not say where they lie in the patient.</source>
        <translation>Die Bilder sagen nicht, wo sie im Patienten liegen.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say where they lie in the patient.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wo sie im Patienten liegen.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how they are oriented in the patient.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wie sie im Patienten ausgerichtet sind.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how large a pixel is.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wie groß ein Pixel ist.</translation>
    </message>
    <message>
        <source>The images do not say how large a pixel is.</source>
        <translation>Die Bilder sagen nicht, wie groß ein Pixel ist.</translation>
    </message>
    <message>
        <source>The size of a pixel is not calibrated; it was taken from %1.</source>
        <translation>Die Pixelgröße ist nicht kalibriert; sie stammt aus: %1.</translation>
    </message>
    <message>
        <source>Do not measure lengths in these images.</source>
        <translation>Messen Sie in diesen Bildern keine Längen.</translation>
    </message>
    <message>
        <source>The orientation or pixel spacing of a slice is not a valid one.</source>
        <translation>Die Ausrichtung oder der Pixelabstand einer Schicht ist ungültig.</translation>
    </message>
    <message>
        <source>The row and column directions are %1 off perpendicular unit vectors, and were set right.</source>
        <translation>Die Richtungen von Zeilen und Spalten weichen um %1 von senkrechten Einheitsvektoren ab und wurden berichtigt.</translation>
    </message>
    <message>
        <source>Slices that are missing: %1 of %2, which are %3 mm apart.</source>
        <translation>Fehlende Schichten: %1 von %2, die %3 mm auseinander liegen.</translation>
    </message>
    <message>
        <source>Slices of the volume that are interpolated, because no image was there: %1 (%2).</source>
        <translation>Schichten des Volumens, die interpoliert sind, weil dort kein Bild war: %1 (%2).</translation>
    </message>
    <message>
        <source>Do not read anything into interpolated slices.</source>
        <translation>Deuten Sie nichts in interpolierte Schichten hinein.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced, %1 to %2 mm apart; they were resampled to an even %3 mm.</source>
        <translation>Die Schichten haben ungleiche Abstände von %1 bis %2 mm; sie wurden auf gleichmäßige %3 mm umgerechnet.</translation>
    </message>
    <message>
        <source>Look at the original images before measuring across slices.</source>
        <translation>Sehen Sie die Originalbilder an, bevor Sie über Schichten hinweg messen.</translation>
    </message>
    <message>
        <source>The slices are too unevenly spaced for a volume, %1 to %2 mm apart.</source>
        <translation>Die Schichten haben für ein Volumen zu ungleiche Abstände, %1 bis %2 mm.</translation>
    </message>
    <message>
        <source>Images whose position is missing or cannot be right, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Position fehlt oder nicht stimmen kann und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>The slices are not quite evenly spaced: a slice is up to %1 mm away from where it is drawn.</source>
        <translation>Die Schichtabstände sind nicht ganz gleich: eine Schicht liegt bis zu %1 mm neben ihrem gezeigten Ort.</translation>
    </message>
    <message>
        <source>Allow for this error when measuring across slices.</source>
        <translation>Berücksichtigen Sie diesen Fehler beim Messen über Schichten hinweg.</translation>
    </message>
    <message>
        <source>The images are not parallel to each other.</source>
        <translation>Die Bilder sind nicht parallel zueinander.</translation>
    </message>
    <message>
        <source>The images do not make a volume: %1.</source>
        <translation>Die Bilder ergeben kein Volumen: %1.</translation>
    </message>
    <message>
        <source>their pixel spacings differ</source>
        <translation>ihre Pixelabstände unterscheiden sich</translation>
    </message>
    <message>
        <source>they are shifted sideways against each other</source>
        <translation>sie sind seitlich gegeneinander verschoben</translation>
    </message>
    <message>
        <source>they lie beside each other</source>
        <translation>sie liegen nebeneinander</translation>
    </message>
    <message>
        <source>each is shifted sideways against the one before</source>
        <translation>jedes ist gegen das vorige seitlich verschoben</translation>
    </message>
    <message>
        <source>their sizes differ</source>
        <translation>ihre Größen unterscheiden sich</translation>
    </message>
    <message>
        <source>they have no pixels</source>
        <translation>sie haben keine Pixel</translation>
    </message>
    <message>
        <source>a unit that is not named</source>
        <translation>einer ungenannten Einheit</translation>
    </message>
    <message>
        <source>the spacing at the detector</source>
        <translation>dem Abstand am Detektor</translation>
    </message>
    <message>
        <source>the nominal spacing of the scanned film</source>
        <translation>dem Nennabstand des gescannten Films</translation>
    </message>
    <message>
        <source>a factor that holds for all images</source>
        <translation>einem Faktor, der für alle Bilder gilt</translation>
    </message>
    <message>
        <source>The slices are stacked at an angle of %1 degrees (tilted gantry), and are drawn so.</source>
        <translation>Die Schichten sind unter einem Winkel von %1 Grad gestapelt (geneigte Gantry) und werden so gezeigt.</translation>
    </message>
    <message>
        <source>The slices are %1 mm thick and %2 mm apart: %3 % of what is between the first and the last was never imaged, and is interpolated here.</source>
        <translation>Die Schichten sind %1 mm dick und %2 mm auseinander: %3 % zwischen der ersten und der letzten wurde nie aufgenommen und ist hier interpoliert.</translation>
    </message>
    <message>
        <source>Do not read anything into what lies between the slices.</source>
        <translation>Deuten Sie nichts in das hinein, was zwischen den Schichten liegt.</translation>
    </message>
    <message>
        <source>This is no image, and cannot be shown here: %1.</source>
        <translation>Das ist kein Bild und kann hier nicht gezeigt werden: %1.</translation>
    </message>
    <message>
        <source>Images of this kind (%1) are no slices of a volume.</source>
        <translation>Bilder dieser Art (%1) sind keine Schichten eines Volumens.</translation>
    </message>
    <message>
        <source>The images are in colour; a volume needs one value per voxel.</source>
        <translation>Die Bilder sind farbig; ein Volumen braucht einen Wert je Voxel.</translation>
    </message>
    <message>
        <source>The pixels are neither whole numbers of 1, 8, 16 or 32 bits nor floating point.</source>
        <translation>Die Pixel sind weder ganze Zahlen mit 1, 8, 16 oder 32 Bit noch Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>This version cannot decode the images: %1.</source>
        <translation>Diese Version kann die Bilder nicht dekodieren: %1.</translation>
    </message>
    <message>
        <source>Export the series uncompressed or in JPEG 2000.</source>
        <translation>Exportieren Sie die Serie unkomprimiert oder in JPEG 2000.</translation>
    </message>
    <message>
        <source>Images whose pixels this version cannot decode, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Pixel diese Version nicht dekodieren kann und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>The images do not say how a value is shown; greater ones were taken as brighter.</source>
        <translation>Die Bilder sagen nicht, wie ein Wert gezeigt wird; größere wurden als heller angenommen.</translation>
    </message>
    <message>
        <source>Each image is a mosaic of many slices (Siemens), which this version does not unpack.</source>
        <translation>Jedes Bild ist ein Mosaik vieler Schichten (Siemens), das diese Version nicht zerlegt.</translation>
    </message>
    <message>
        <source>Export the series again as one image for each slice, or convert it with dcm2niix.</source>
        <translation>Exportieren Sie die Serie noch einmal mit einem Bild je Schicht, oder wandeln Sie sie mit dcm2niix um.</translation>
    </message>
    <message>
        <source>These values are a dose distribution, in %1, and no anatomy.</source>
        <translation>Diese Werte sind eine Dosisverteilung in %1 und keine Anatomie.</translation>
    </message>
    <message>
        <source>To see anatomy, choose the images that the treatment was planned on.</source>
        <translation>Um Anatomie zu sehen, wählen Sie die Bilder, auf denen die Behandlung geplant wurde.</translation>
    </message>
    <message>
        <source>of the reference dose</source>
        <translation>der Referenzdosis</translation>
    </message>
    <message>
        <source>The values come from a lookup table in the images, which was applied.</source>
        <translation>Die Werte kommen aus einer Tabelle in den Bildern, die angewendet wurde.</translation>
    </message>
    <message>
        <source>The lookup table that makes values of the pixels is not a usable one.</source>
        <translation>Die Tabelle, die aus Pixeln Werte macht, ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>The rescale slope or intercept of an image is not a usable number.</source>
        <translation>Rescale Slope oder Intercept eines Bildes ist keine brauchbare Zahl.</translation>
    </message>
    <message>
        <source>Images that do not say how stored numbers become values: %1 of %2. A missing rescale slope was taken as 1, a missing intercept as 0.</source>
        <translation>Bilder, die nicht sagen, wie aus gespeicherten Zahlen Werte werden: %1 von %2. Ein fehlender Rescale Slope wurde als 1, ein fehlender Intercept als 0 angenommen.</translation>
    </message>
    <message>
        <source>Do not rely on the values; presets made for Hounsfield units may not fit.</source>
        <translation>Verlassen Sie sich nicht auf die Werte; Voreinstellungen für Hounsfield-Einheiten passen vielleicht nicht.</translation>
    </message>
    <message>
        <source>These CT images do not say that their values are Hounsfield units (%1); they are taken as plain numbers.</source>
        <translation>Diese CT-Bilder sagen nicht, dass ihre Werte Hounsfield-Einheiten sind (%1); sie gelten als einfache Zahlen.</translation>
    </message>
    <message>
        <source>Presets for Hounsfield units do not fit, and the table cannot be removed. Use the original images.</source>
        <translation>Voreinstellungen für Hounsfield-Einheiten passen nicht, und der Tisch kann nicht entfernt werden. Verwenden Sie die Originalbilder.</translation>
    </message>
    <message>
        <source>no rescale slope and intercept</source>
        <translation>kein Rescale Slope und Intercept</translation>
    </message>
    <message>
        <source>their rescale type is another</source>
        <translation>ihr Rescale Type ist ein anderer</translation>
    </message>
    <message>
        <source>their lookup table does not say what it leads to</source>
        <translation>ihre Tabelle sagt nicht, wohin sie führt</translation>
    </message>
    <message>
        <source>pixels of 8 bits, as of a capture</source>
        <translation>Pixel mit 8 Bit, wie bei einem Capture</translation>
    </message>
    <message>
        <source>they are no CT image objects</source>
        <translation>sie sind keine CT-Bildobjekte</translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is missing or cannot be right, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Rescale Slope oder Intercept fehlt oder nicht stimmen kann und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is another than that of all others; it was applied as it is: %1.</source>
        <translation>Bilder, deren Rescale Slope oder Intercept ein anderer ist als bei allen übrigen; er wurde so angewendet: %1.</translation>
    </message>
    <message>
        <source>Compare these slices with their neighbours; if they are brighter or darker, copy the series again from its source.</source>
        <translation>Vergleichen Sie diese Schichten mit ihren Nachbarn; sind sie heller oder dunkler, kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Each image has its own rescale factors; they are applied image by image.</source>
        <translation>Jedes Bild hat eigene Rescale-Faktoren; sie werden Bild für Bild angewendet.</translation>
    </message>
    <message>
        <source>The values are the real world values that the images define, in %1.</source>
        <translation>Die Werte sind die Real World Values, die die Bilder festlegen, in %1.</translation>
    </message>
    <message>
        <source>Standardised uptake values cannot be worked out: %1 is missing or not usable.</source>
        <translation>Standardisierte Aufnahmewerte (SUV) können nicht berechnet werden: %1 fehlt oder ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Images whose values need more bits than they say, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Werte mehr Bits brauchen, als sie angeben, und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>Images with bits outside of those that they say hold the values: %1 of %2. These bits were dropped.</source>
        <translation>Bilder mit Bits außerhalb derer, die laut Angabe die Werte enthalten: %1 von %2. Diese Bits wurden weggelassen.</translation>
    </message>
    <message>
        <source>Compare the values with those that another program shows.</source>
        <translation>Vergleichen Sie die Werte mit denen, die ein anderes Programm zeigt.</translation>
    </message>
    <message>
        <source>Pixels that are no finite number: %1. They are treated as outside of the scan.</source>
        <translation>Pixel, die keine endliche Zahl sind: %1. Sie gelten als außerhalb der Aufnahme.</translation>
    </message>
    <message>
        <source>Do not read anything into the places where they are.</source>
        <translation>Deuten Sie nichts in die Stellen hinein, an denen sie sind.</translation>
    </message>
    <message>
        <source>The images were compressed with loss; fine detail may be missing or false.</source>
        <translation>Die Bilder wurden verlustbehaftet komprimiert; feine Einzelheiten können fehlen oder falsch sein.</translation>
    </message>
    <message>
        <source>Use the original images for diagnosis.</source>
        <translation>Verwenden Sie zur Diagnose die Originalbilder.</translation>
    </message>
    <message>
        <source>The images are meant to be shown with low values bright (MONOCHROME1); values are as stored.</source>
        <translation>Die Bilder sind dafür gedacht, niedrige Werte hell zu zeigen (MONOCHROME1); Werte sind wie gespeichert.</translation>
    </message>
    <message>
        <source>The display window of these images is not usable, and was ignored.</source>
        <translation>Die Fensterung dieser Bilder ist nicht brauchbar und wurde nicht beachtet.</translation>
    </message>
    <message>
        <source>%1 voxels belong to several segments; of each only the last is shown.</source>
        <translation>%1 Voxel gehören zu mehreren Segmenten; von jedem wird nur das letzte gezeigt.</translation>
    </message>
    <message>
        <source>Look at the segments one by one in the program that made them.</source>
        <translation>Sehen Sie die Segmente einzeln in dem Programm an, das sie erstellt hat.</translation>
    </message>
    <message>
        <source>%1 voxels of the segmentation lie outside of the volume, and are not shown.</source>
        <translation>%1 Voxel der Segmentierung liegen außerhalb des Volumens und werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>Check that no slices of the series are missing.</source>
        <translation>Prüfen Sie, ob Schichten der Serie fehlen.</translation>
    </message>
    <message>
        <source>The only volume%1.</source>
        <translation>Das einzige Volumen%1.</translation>
    </message>
    <message>
        <source>Of %1 volumes%2 the %3one %4with the most voxels (%5 x %6 x %7).</source>
        <translation>Von %1 Volumen%2 das %3%4mit den meisten Voxeln (%5 x %6 x %7).</translation>
    </message>
    <message>
        <source>it is no volume.</source>
        <translation>es ist kein Volumen.</translation>
    </message>
    <message>
        <source>of %1 patients in this folder</source>
        <translation>von %1 Patienten in diesem Ordner</translation>
    </message>
    <message>
        <source>in this series</source>
        <translation>in dieser Serie</translation>
    </message>
    <message>
        <source>Its series has %1 other stack of images.</source>
        <translation>Ihre Serie hat %1 weiteren Bildstapel.</translation>
    </message>
    <message>
        <source>Its series has %1 other stacks of images.</source>
        <translation>Ihre Serie hat %1 weitere Bildstapel.</translation>
    </message>
    <message>
        <source>There are no images.</source>
        <translation>Es gibt keine Bilder.</translation>
    </message>
    <message>
        <source>There are no images in this series.</source>
        <translation>In dieser Serie sind keine Bilder.</translation>
    </message>
    <message>
        <source>Nothing can be shown in 3D. The largest of %1 stacks of images: %2</source>
        <translation>Nichts kann in 3D gezeigt werden. Der größte von %1 Bildstapeln: %2</translation>
    </message>
    <message>
        <source>The image has no usable size.</source>
        <translation>Das Bild hat keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode the image.</source>
        <translation>Es ist nicht genug Speicher da, um das Bild zu dekodieren.</translation>
    </message>
    <message>
        <source>Close other programs, or choose a smaller series.</source>
        <translation>Schließen Sie andere Programme, oder wählen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>The image cannot be decoded.</source>
        <translation>Das Bild kann nicht dekodiert werden.</translation>
    </message>
    <message>
        <source>This series is no volume.</source>
        <translation>Diese Serie ist kein Volumen.</translation>
    </message>
    <message>
        <source>The images of this series have no usable size.</source>
        <translation>Die Bilder dieser Serie haben keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>The images of this series differ in size or in kind.</source>
        <translation>Die Bilder dieser Serie unterscheiden sich in Größe oder Art.</translation>
    </message>
    <message>
        <source>Export the series again.</source>
        <translation>Exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>%1 of the %2 images cannot be decoded. %3</source>
        <translation>%1 der %2 Bilder können nicht dekodiert werden. %3</translation>
    </message>
    <message>
        <source>Decoding %1 slices</source>
        <translation>%1 Schichten werden dekodiert</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Das Laden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>This series cannot be loaded.</source>
        <translation>Diese Serie kann nicht geladen werden.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode the slices.</source>
        <translation>Es ist nicht genug Speicher da, um die Schichten zu dekodieren.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode a slice.</source>
        <translation>Es ist nicht genug Speicher da, um eine Schicht zu dekodieren.</translation>
    </message>
    <message>
        <source>%1 of %2 slices declare no padding value; that of the others was taken for them.</source>
        <translation>%1 von %2 Schichten nennen keinen Füllwert; für sie gilt der der anderen.</translation>
    </message>
    <message>
        <source>The compressed image in this file is damaged.</source>
        <translation>Das komprimierte Bild in dieser Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The JPEG 2000 image in this file cannot be decoded.</source>
        <translation>Das JPEG-2000-Bild in dieser Datei kann nicht dekodiert werden.</translation>
    </message>
    <message>
        <source>The pixel data of this file are damaged.</source>
        <translation>Die Pixeldaten dieser Datei sind beschädigt.</translation>
    </message>
    <message>
        <source>The file ends before its pixel data do.</source>
        <translation>Die Datei endet vor ihren Pixeldaten.</translation>
    </message>
    <message>
        <source>This version cannot decode this image: %1.</source>
        <translation>Diese Version kann dieses Bild nicht dekodieren: %1.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that the file or disc is still there.</source>
        <translation>Prüfen Sie, ob Datei oder Datenträger noch da ist.</translation>
    </message>
    <message>
        <source>The file has changed since the folder was read.</source>
        <translation>Die Datei hat sich geändert, seit der Ordner gelesen wurde.</translation>
    </message>
    <message>
        <source>Open the folder again.</source>
        <translation>Öffnen Sie den Ordner noch einmal.</translation>
    </message>
    <message>
        <source>The file has no pixel data that fit its header.</source>
        <translation>Die Datei hat keine Pixeldaten, die zu ihrem Kopf passen.</translation>
    </message>
    <message>
        <source>It cannot be told where the images in this file begin.</source>
        <translation>Es ist nicht zu erkennen, wo die Bilder in dieser Datei beginnen.</translation>
    </message>
    <message>
        <source>The pixel data of this file cannot be decoded.</source>
        <translation>Die Pixeldaten dieser Datei können nicht dekodiert werden.</translation>
    </message>
    <message>
        <source>The images of this file have no usable size.</source>
        <translation>Die Bilder dieser Datei haben keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>The folder does not exist.</source>
        <translation>Den Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>The folder cannot be read.</source>
        <translation>Der Ordner kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that it is a folder, and its permissions.</source>
        <translation>Prüfen Sie, ob es ein Ordner ist, und seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>Reading was cancelled.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The file is not the directory of a DICOM disc.</source>
        <translation>Die Datei ist nicht das Verzeichnis eines DICOM-Datenträgers.</translation>
    </message>
    <message>
        <source>Open the folder instead.</source>
        <translation>Öffnen Sie stattdessen den Ordner.</translation>
    </message>
    <message>
        <source>There is not enough memory to read this disc.</source>
        <translation>Es ist nicht genug Speicher da, um diesen Datenträger zu lesen.</translation>
    </message>
    <message>
        <source>The directory of this disc cannot be read.</source>
        <translation>Das Verzeichnis dieses Datenträgers kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>None of the %1 DICOM files in this folder can be read.</source>
        <translation>Keine der %1 DICOM-Dateien in diesem Ordner kann gelesen werden.</translation>
    </message>
    <message>
        <source>Copy the study again from its source.</source>
        <translation>Kopieren Sie die Studie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>There is no DICOM image in the folder, and some of its sub-folders cannot be read.</source>
        <translation>Im Ordner ist kein DICOM-Bild, und manche seiner Unterordner können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check the permissions of the sub-folders.</source>
        <translation>Prüfen Sie die Zugriffsrechte der Unterordner.</translation>
    </message>
    <message>
        <source>There is no DICOM image in the folder itself; links that lead out of it are not followed.</source>
        <translation>Im Ordner selbst ist kein DICOM-Bild; Verknüpfungen, die hinausführen, wird nicht gefolgt.</translation>
    </message>
    <message>
        <source>Choose the folder that the links lead to.</source>
        <translation>Wählen Sie den Ordner, zu dem die Verknüpfungen führen.</translation>
    </message>
    <message>
        <source>The file is not a DICOM image.</source>
        <translation>Die Datei ist kein DICOM-Bild.</translation>
    </message>
    <message>
        <source>There is no DICOM image among the %1 files of this folder.</source>
        <translation>Unter den %1 Dateien dieses Ordners ist kein DICOM-Bild.</translation>
    </message>
    <message>
        <source>Choose a folder with DICOM images.</source>
        <translation>Wählen Sie einen Ordner mit DICOM-Bildern.</translation>
    </message>
    <message>
        <source>Looking for files</source>
        <translation>Dateien werden gesucht</translation>
    </message>
    <message>
        <source>Reading %1 files</source>
        <translation>%1 Dateien werden gelesen</translation>
    </message>
    <message>
        <source>Comparing %1 files</source>
        <translation>%1 Dateien werden verglichen</translation>
    </message>
    <message>
        <source>There is not enough memory to read this folder.</source>
        <translation>Es ist nicht genug Speicher da, um diesen Ordner zu lesen.</translation>
    </message>
    <message>
        <source>Choose a smaller folder.</source>
        <translation>Wählen Sie einen kleineren Ordner.</translation>
    </message>
    <message>
        <source>The dictionary of the DICOM toolkit (dicom.dic) is not there, so that DICOM files cannot be read.</source>
        <translation>Das Wörterbuch des DICOM-Toolkits (dicom.dic) fehlt, sodass DICOM-Dateien nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>Install DCMTK&apos;s data files again, or set DCMDICTPATH to the path of dicom.dic.</source>
        <translation>Installieren Sie die Datendateien von DCMTK noch einmal, oder setzen Sie DCMDICTPATH auf den Pfad von dicom.dic.</translation>
    </message>
    <message>
        <source>A picture of that size cannot be written as DICOM.</source>
        <translation>Ein Bild dieser Größe kann nicht als DICOM geschrieben werden.</translation>
    </message>
    <message>
        <source>Take 1 to %1 pixels for each side.</source>
        <translation>Nehmen Sie 1 bis %1 Pixel für jede Seite.</translation>
    </message>
    <message>
        <source>The files of this study do not say which patient and which study it is.</source>
        <translation>Die Dateien dieser Studie sagen nicht, welcher Patient und welche Studie es ist.</translation>
    </message>
    <message>
        <source>Write the picture without patient and study, or as PNG.</source>
        <translation>Speichern Sie das Bild ohne Patient und Studie oder als PNG.</translation>
    </message>
    <message>
        <source>The study that the picture belongs to cannot be read any more.</source>
        <translation>Die Studie, zu der das Bild gehört, kann nicht mehr gelesen werden.</translation>
    </message>
    <message>
        <source>Open the study again, or write the picture without the patient.</source>
        <translation>Öffnen Sie die Studie noch einmal, oder speichern Sie das Bild ohne den Patienten.</translation>
    </message>
    <message>
        <source>The DICOM file could not be written.</source>
        <translation>Die DICOM-Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check free space and permissions.</source>
        <translation>Prüfen Sie freien Platz und Zugriffsrechte.</translation>
    </message>
    <message>
        <source>Check free space and memory.</source>
        <translation>Prüfen Sie freien Platz und Speicher.</translation>
    </message>
    <message>
        <source>The segmentation cannot be read.</source>
        <translation>Die Segmentierung kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Choose another segmentation.</source>
        <translation>Wählen Sie eine andere Segmentierung.</translation>
    </message>
    <message>
        <source>The file is no segmentation that this version knows.</source>
        <translation>Die Datei ist keine Segmentierung, die diese Version kennt.</translation>
    </message>
    <message>
        <source>There is not enough memory to load the segmentation.</source>
        <translation>Es ist nicht genug Speicher da, um die Segmentierung zu laden.</translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation>Schließen Sie andere Programme.</translation>
    </message>
</context>
<context>
    <name>formats</name>
    <message>
        <source>This is no MetaImage file.</source>
        <translation>Das ist keine MetaImage-Datei.</translation>
    </message>
    <message>
        <source>The image has several values in each voxel; a volume needs one.</source>
        <translation>Das Bild hat mehrere Werte in jedem Voxel; ein Volumen braucht einen.</translation>
    </message>
    <message>
        <source>The values of the image are neither whole numbers of 8 to 32 bits nor floating-point ones.</source>
        <translation>Die Werte des Bildes sind weder ganze Zahlen mit 8 bis 32 Bit noch Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>The file does not give the distance of the voxels: 1 mm was assumed.</source>
        <translation>Die Datei nennt den Abstand der Voxel nicht: 1 mm wurde angenommen.</translation>
    </message>
    <message>
        <source>The values are written as text, which Macula does not read.</source>
        <translation>Die Werte sind als Text geschrieben, den Macula nicht liest.</translation>
    </message>
    <message>
        <source>Write the file with BinaryData = True.</source>
        <translation>Schreiben Sie die Datei mit BinaryData = True.</translation>
    </message>
    <message>
        <source>The values lie in several files.</source>
        <translation>Die Werte liegen in mehreren Dateien.</translation>
    </message>
    <message>
        <source>Write the volume to one file.</source>
        <translation>Schreiben Sie das Volumen in eine Datei.</translation>
    </message>
    <message>
        <source>Convert it with the program it comes from.</source>
        <translation>Wandeln Sie sie mit dem Programm um, aus dem sie kommt.</translation>
    </message>
    <message>
        <source>The file is cut off or damaged.</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>Get the file again from where it came.</source>
        <translation>Holen Sie die Datei noch einmal, woher sie kam.</translation>
    </message>
    <message>
        <source>Check the path and its permissions.</source>
        <translation>Prüfen Sie den Pfad und seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>This is a NIfTI-2 file; Macula reads NIfTI-1.</source>
        <translation>Das ist eine NIfTI-2-Datei; Macula liest NIfTI-1.</translation>
    </message>
    <message>
        <source>This is no NIfTI file.</source>
        <translation>Das ist keine NIfTI-Datei.</translation>
    </message>
    <message>
        <source>The image is in colour; a volume needs one value in each voxel.</source>
        <translation>Das Bild ist farbig; ein Volumen braucht einen Wert in jedem Voxel.</translation>
    </message>
    <message>
        <source>The header of the NIfTI file is damaged.</source>
        <translation>Der Kopf der NIfTI-Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The file holds %1 volumes, one for each point in time; Macula reads one.</source>
        <translation>Die Datei enthält %1 Volumen, eines je Zeitpunkt; Macula liest eines.</translation>
    </message>
    <message>
        <source>Write one of them to a file of its own.</source>
        <translation>Schreiben Sie eines davon in eine eigene Datei.</translation>
    </message>
    <message>
        <source>The file gives two positions in the patient that differ by up to %1 mm (sform and qform): the sform was taken.</source>
        <translation>Die Datei gibt zwei Lagen im Patienten an, die um bis zu %1 mm abweichen (sform und qform): die sform wurde genommen.</translation>
    </message>
    <message>
        <source>The file does not say how the image lies in the patient: its axes were taken to lead to the right, to the front and up. Left and right may be exchanged.</source>
        <translation>Die Datei sagt nicht, wie das Bild im Patienten liegt: es wurde angenommen, dass seine Achsen nach rechts, vorn und oben führen. Links und rechts können vertauscht sein.</translation>
    </message>
    <message>
        <source>The file does not say how the image lies in the patient: its axes were taken to lead to the patient&apos;s left, back and head. Left and right may be exchanged.</source>
        <translation>Die Datei sagt nicht, wie das Bild im Patienten liegt: es wurde angenommen, dass seine Achsen nach links, hinten und zum Kopf des Patienten führen. Links und rechts können vertauscht sein.</translation>
    </message>
    <message>
        <source>The header and the image lie in two files (.hdr and .img).</source>
        <translation>Kopf und Bild liegen in zwei Dateien (.hdr und .img).</translation>
    </message>
    <message>
        <source>Write them to one .nii file.</source>
        <translation>Schreiben Sie sie in eine .nii-Datei.</translation>
    </message>
    <message>
        <source>This is an ANALYZE file, which does not tell left from right.</source>
        <translation>Das ist eine ANALYZE-Datei, die links und rechts nicht unterscheidet.</translation>
    </message>
    <message>
        <source>Write it as NIfTI.</source>
        <translation>Schreiben Sie sie als NIfTI.</translation>
    </message>
    <message>
        <source>The position of the image in the patient is not usable: its axes do not span a volume.</source>
        <translation>Die Lage des Bildes im Patienten ist nicht brauchbar: seine Achsen spannen kein Volumen auf.</translation>
    </message>
    <message>
        <source>This is no NRRD file.</source>
        <translation>Das ist keine NRRD-Datei.</translation>
    </message>
    <message>
        <source>The position of the image is not given in millimetres.</source>
        <translation>Die Lage des Bildes ist nicht in Millimetern angegeben.</translation>
    </message>
    <message>
        <source>Write one volume to a file of its own.</source>
        <translation>Schreiben Sie ein Volumen in eine eigene Datei.</translation>
    </message>
    <message>
        <source>The values are encoded in a way that Macula does not read.</source>
        <translation>Die Werte sind auf eine Weise kodiert, die Macula nicht liest.</translation>
    </message>
    <message>
        <source>Write the file with the encoding raw or gzip.</source>
        <translation>Schreiben Sie die Datei mit der Kodierung raw oder gzip.</translation>
    </message>
    <message>
        <source>Preparing the values</source>
        <translation>Die Werte werden vorbereitet</translation>
    </message>
    <message>
        <source>The file does not name the unit of its values: none was assumed. Presets for Hounsfield units do not fit.</source>
        <translation>Die Datei nennt die Einheit ihrer Werte nicht: keine wurde angenommen. Voreinstellungen für Hounsfield-Einheiten passen nicht.</translation>
    </message>
    <message>
        <source>Macula wrote this file, with values in %1; a program that changed them since need not have said so.</source>
        <translation>Macula hat diese Datei geschrieben, mit Werten in %1; ein Programm, das sie seither geändert hat, muss das nicht gesagt haben.</translation>
    </message>
    <message>
        <source>Values were rounded to 24 significant bits.</source>
        <translation>Werte wurden auf 24 signifikante Bits gerundet.</translation>
    </message>
    <message>
        <source>%1 voxels hold no finite number: they are treated as outside of the scan.</source>
        <translation>%1 Voxel enthalten keine endliche Zahl: sie gelten als außerhalb der Aufnahme.</translation>
    </message>
    <message>
        <source>The image of %1 x %2 x %3 voxels is no volume.</source>
        <translation>Das Bild aus %1 x %2 x %3 Voxeln ist kein Volumen.</translation>
    </message>
    <message>
        <source>Choose a file with a volume.</source>
        <translation>Wählen Sie eine Datei mit einem Volumen.</translation>
    </message>
    <message>
        <source>A volume of %1 x %2 x %3 voxels cannot be shown.</source>
        <translation>Ein Volumen aus %1 x %2 x %3 Voxeln kann nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Choose a smaller one.</source>
        <translation>Wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>The file is cut off: its header tells of %1 x %2 x %3 voxels, and it is too short for them.</source>
        <translation>Die Datei ist abgeschnitten: ihr Kopf nennt %1 x %2 x %3 Voxel, und dafür ist sie zu kurz.</translation>
    </message>
    <message>
        <source>The map from stored values to units is not usable.</source>
        <translation>Die Abbildung gespeicherter Werte auf Einheiten ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Export the file again.</source>
        <translation>Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The header of the file is damaged.</source>
        <translation>Der Kopf der Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The image has two axes; it is no volume.</source>
        <translation>Das Bild hat zwei Achsen; es ist kein Volumen.</translation>
    </message>
    <message>
        <source>The image has %1 axes; Macula reads volumes with three.</source>
        <translation>Das Bild hat %1 Achsen; Macula liest Volumen mit drei.</translation>
    </message>
    <message>
        <source>The file with the values is missing.</source>
        <translation>Die Datei mit den Werten fehlt.</translation>
    </message>
    <message>
        <source>Put it beside the header.</source>
        <translation>Legen Sie sie neben den Kopf.</translation>
    </message>
    <message>
        <source>The ending of the name is that of no volume file.</source>
        <translation>Die Endung des Namens ist die keiner Volumendatei.</translation>
    </message>
    <message>
        <source>The file does not exist.</source>
        <translation>Die Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>There is not enough free space.</source>
        <translation>Es ist nicht genug Platz frei.</translation>
    </message>
    <message>
        <source>The file needs %1 MB.</source>
        <translation>Die Datei braucht %1 MB.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Es ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>There is not enough memory for this volume.</source>
        <translation>Es ist nicht genug Speicher für dieses Volumen da.</translation>
    </message>
    <message>
        <source>Close other programs, or choose a smaller one.</source>
        <translation>Schließen Sie andere Programme, oder wählen Sie ein kleineres.</translation>
    </message>
</context>
<context>
    <name>segment</name>
    <message>
        <source>The patient could not be told from the table.</source>
        <translation>Der Patient konnte nicht vom Tisch unterschieden werden.</translation>
    </message>
    <message>
        <source>Close other programs, or show the volume with the table.</source>
        <translation>Schließen Sie andere Programme, oder zeigen Sie das Volumen mit dem Tisch.</translation>
    </message>
    <message>
        <source>The table is left out, and whatever else lies apart from the patient: %1 parts, %2 mL (confidence %3).</source>
        <translation>Der Tisch und was sonst abseits des Patienten liegt, ist weggelassen: %1 Teile, %2 mL (Sicherheit: %3).</translation>
    </message>
    <message>
        <source>Show the table again to see everything that was scanned.</source>
        <translation>Zeigen Sie den Tisch wieder, um alles Aufgenommene zu sehen.</translation>
    </message>
    <message>
        <source>No table was found. What lies apart from the patient is left out: %1 parts, %2 mL (confidence %3).</source>
        <translation>Kein Tisch wurde gefunden. Was abseits des Patienten liegt, ist weggelassen: %1 Teile, %2 mL (Sicherheit: %3).</translation>
    </message>
    <message>
        <source>Nothing lies apart from the patient; nothing is left out.</source>
        <translation>Nichts liegt abseits des Patienten; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>The patient lies against the table in %1 of %2 slices of the search grid; the surface between them is an estimate there, to about 3 mm.</source>
        <translation>Der Patient liegt in %1 von %2 Schichten des Suchgitters am Tisch an; die Fläche dazwischen ist dort auf etwa 3 mm geschätzt.</translation>
    </message>
    <message>
        <source>Do not judge the skin of the side that the patient lies on; show the table again for that.</source>
        <translation>Beurteilen Sie die Haut der Seite nicht, auf der der Patient liegt; zeigen Sie dafür den Tisch wieder.</translation>
    </message>
    <message>
        <source>It is not clear what is patient and what is table; nothing is left out.</source>
        <translation>Es ist nicht klar, was Patient und was Tisch ist; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>Cut the table away with a clip plane or box.</source>
        <translation>Schneiden Sie den Tisch mit einer Schnittebene oder einem Quader weg.</translation>
    </message>
    <message>
        <source>No patient was found in these images; nothing is left out.</source>
        <translation>In diesen Bildern wurde kein Patient gefunden; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>Telling the patient from the table was cancelled.</source>
        <translation>Die Suche nach dem Tisch wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Telling the patient from the table</source>
        <translation>Patient und Tisch werden unterschieden</translation>
    </message>
    <message>
        <source>The table can be left out of CT in Hounsfield units only.</source>
        <translation>Der Tisch kann nur bei CT in Hounsfield-Einheiten weggelassen werden.</translation>
    </message>
    <message>
        <source>Show these images with the table, or cut it away with a clip plane or box.</source>
        <translation>Zeigen Sie diese Bilder mit dem Tisch, oder schneiden Sie ihn mit einer Schnittebene oder einem Quader weg.</translation>
    </message>
    <message>
        <source>There is not enough memory to tell the patient from the table.</source>
        <translation>Es ist nicht genug Speicher da, um Patient und Tisch zu unterscheiden.</translation>
    </message>
</context>
<context>
    <name>base</name>
    <message>
        <source>The file could not be written.</source>
        <translation>Die Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The file could not be written: %1.</source>
        <translation>Die Datei konnte nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>The file is larger than %1 bytes.</source>
        <translation>Die Datei ist größer als %1 Bytes.</translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation>Prüfen Sie, ob es die gemeinte Datei ist.</translation>
    </message>
    <message>
        <source>The file could not be read.</source>
        <translation>Die Datei konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>There is not enough memory for this series: it needs %1, and %2 are free.</source>
        <translation>Für diese Serie ist nicht genug Speicher da: sie braucht %1, und %2 sind frei.</translation>
    </message>
    <message>
        <source>There is not enough memory for this series: it needs %1.</source>
        <translation>Für diese Serie ist nicht genug Speicher da: sie braucht %1.</translation>
    </message>
    <message>
        <source>The system has no random numbers.</source>
        <translation>Das System hat keine Zufallszahlen.</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The folder to write into does not exist.</source>
        <translation>Den Zielordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Create it, or choose another place.</source>
        <translation>Legen Sie ihn an, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>What stands there is no file.</source>
        <translation>Was dort steht, ist keine Datei.</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>A part of Macula could not be loaded.</source>
        <translation>Ein Teil von Macula konnte nicht geladen werden.</translation>
    </message>
    <message>
        <source>Install Macula again, with the packages that it depends on.</source>
        <translation>Installieren Sie Macula noch einmal, mit den Paketen, die es braucht.</translation>
    </message>
    <message>
        <source>The position of the voxels in the patient is not usable: the axes do not span a volume.</source>
        <translation>Die Lage der Voxel im Patienten ist nicht brauchbar: die Achsen spannen kein Volumen auf.</translation>
    </message>
    <message>
        <source>The values were brought to 16 bits for the picture, with an error of at most %1.</source>
        <translation>Die Werte wurden für das Bild auf 16 Bit gebracht, mit einem Fehler von höchstens %1.</translation>
    </message>
</context>
<context>
    <name>app</name>
    <message>
        <source>There is no such preset.</source>
        <translation>Diese Voreinstellung gibt es nicht.</translation>
    </message>
    <message>
        <source>There are no such lights.</source>
        <translation>Diese Beleuchtung gibt es nicht.</translation>
    </message>
    <message>
        <source>The place of the clip is not a number.</source>
        <translation>Der Ort des Beschnitts ist keine Zahl.</translation>
    </message>
    <message>
        <source>Give it in mm.</source>
        <translation>Geben Sie ihn in mm an.</translation>
    </message>
    <message>
        <source>Nothing of the volume would be left.</source>
        <translation>Vom Volumen bliebe nichts übrig.</translation>
    </message>
    <message>
        <source>Choose another place, or begin without a clip.</source>
        <translation>Wählen Sie einen anderen Ort, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>A clip with a box of another kind has six planes and no more.</source>
        <translation>Ein Beschnitt mit einem anderen Quader hat sechs Ebenen und nicht mehr.</translation>
    </message>
    <message>
        <source>Open another face first, or begin without a clip.</source>
        <translation>Öffnen Sie zuerst eine andere Fläche, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>Nothing is left to remove on the %1 side.</source>
        <translation>Auf der Seite %1 ist nichts mehr zu entfernen.</translation>
    </message>
    <message>
        <source>Move the cross-hair into what is shown.</source>
        <translation>Bewegen Sie das Fadenkreuz in das Gezeigte.</translation>
    </message>
    <message>
        <source>The slab has no thickness.</source>
        <translation>Der Slab hat keine Dicke.</translation>
    </message>
    <message>
        <source>Give it in mm, more than 0.</source>
        <translation>Geben Sie sie in mm an, größer als 0.</translation>
    </message>
    <message>
        <source>The slab would be outside of the volume.</source>
        <translation>Der Slab läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>Move the cross-hair into the volume.</source>
        <translation>Bewegen Sie das Fadenkreuz in das Volumen.</translation>
    </message>
    <message>
        <source>The corner would be outside of the volume.</source>
        <translation>Die Ecke läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>A ball of that size is not possible here.</source>
        <translation>Eine Kugel dieser Größe ist hier nicht möglich.</translation>
    </message>
    <message>
        <source>Give a radius from %1 to %2 mm.</source>
        <translation>Geben Sie einen Radius von %1 bis %2 mm an.</translation>
    </message>
    <message>
        <source>The ball would be outside of the volume.</source>
        <translation>Die Kugel läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>There is no clip to turn inside out.</source>
        <translation>Es gibt keinen Beschnitt zum Umkehren.</translation>
    </message>
    <message>
        <source>Choose a clip, or cut something off.</source>
        <translation>Wählen Sie einen Beschnitt, oder schneiden Sie etwas ab.</translation>
    </message>
    <message>
        <source>Only a clip of one part can be turned inside out.</source>
        <translation>Nur ein Beschnitt aus einem Teil kann umgekehrt werden.</translation>
    </message>
    <message>
        <source>This one has %1; begin without a clip.</source>
        <translation>Dieser hat %1; beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>The clip leaves nothing of this volume.</source>
        <translation>Der Beschnitt lässt von diesem Volumen nichts übrig.</translation>
    </message>
    <message>
        <source>Begin again without a clip.</source>
        <translation>Beginnen Sie noch einmal ohne Beschnitt.</translation>
    </message>
    <message>
        <source>splats only</source>
        <translation>nur Splats</translation>
    </message>
    <message>
        <source>splats around the fovea</source>
        <translation>Splats um die Fovea</translation>
    </message>
    <message>
        <source>fovea traced %1 s ago with %2 samples</source>
        <translation>Fovea vor %1 s mit %2 Abtastungen verfolgt</translation>
    </message>
    <message>
        <source>values on cut faces only coarsely</source>
        <translation>Werte auf Schnittflächen nur grob</translation>
    </message>
    <message>
        <source>splats fade out</source>
        <translation>Splats blenden aus</translation>
    </message>
    <message>
        <source>1/%1 of the pixels each way</source>
        <translation>1/%1 der Pixel je Richtung</translation>
    </message>
    <message>
        <source>%1 of %2 samples</source>
        <translation>%1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>less than the full resolution</source>
        <translation>weniger als die volle Auflösung</translation>
    </message>
    <message>
        <source>denoised</source>
        <translation>entrauscht</translation>
    </message>
    <message>
        <source>%1 samples left out</source>
        <translation>%1 Abtastungen ausgelassen</translation>
    </message>
    <message>
        <source>shaded</source>
        <translation>schattiert</translation>
    </message>
    <message>
        <source>table left out</source>
        <translation>Tisch weggelassen</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>beschnitten</translation>
    </message>
    <message>
        <source>There was no memory to keep the peripheral model.</source>
        <translation>Es war kein Speicher da, um das periphere Modell zu behalten.</translation>
    </message>
    <message>
        <source>There is not enough memory to show this study.</source>
        <translation>Es ist nicht genug Speicher da, um diese Studie zu zeigen.</translation>
    </message>
    <message>
        <source>Close other programs, or open a smaller series.</source>
        <translation>Schließen Sie andere Programme, oder öffnen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>The picture could not be made.</source>
        <translation>Das Bild konnte nicht erstellt werden.</translation>
    </message>
    <message>
        <source>Open the study again, or start the program with another --device.</source>
        <translation>Öffnen Sie die Studie noch einmal, oder starten Sie das Programm mit einem anderen --device.</translation>
    </message>
    <message>
        <source>Starting the graphics device</source>
        <translation>Das Grafikgerät wird gestartet</translation>
    </message>
    <message>
        <source>Preparing the volume</source>
        <translation>Das Volumen wird vorbereitet</translation>
    </message>
    <message>
        <source>Preparing what is shown</source>
        <translation>Das Gezeigte wird vorbereitet</translation>
    </message>
    <message>
        <source>There is no room on the device for a traced fovea.</source>
        <translation>Auf dem Gerät ist kein Platz für eine verfolgte Fovea.</translation>
    </message>
    <message>
        <source>There is not enough memory for it.</source>
        <translation>Dafür ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is no room on the device to denoise a picture of this size.</source>
        <translation>Auf dem Gerät ist kein Platz, um ein Bild dieser Größe zu entrauschen.</translation>
    </message>
    <message>
        <source>Measurements are written to a .csv or .json file.</source>
        <translation>Messungen werden in eine .csv- oder .json-Datei geschrieben.</translation>
    </message>
    <message>
        <source>Choose a name with one of these endings.</source>
        <translation>Wählen Sie einen Namen mit einer dieser Endungen.</translation>
    </message>
    <message>
        <source>There is a folder of that name.</source>
        <translation>Es gibt einen Ordner dieses Namens.</translation>
    </message>
    <message>
        <source>Nothing can be written there.</source>
        <translation>Dort kann nichts geschrieben werden.</translation>
    </message>
    <message>
        <source>Check the permissions, or choose another place.</source>
        <translation>Prüfen Sie die Zugriffsrechte, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The file belongs to the folder that is read.</source>
        <translation>Die Datei gehört zu dem Ordner, der gelesen wird.</translation>
    </message>
    <message>
        <source>The file is one of those that are read.</source>
        <translation>Die Datei ist eine von denen, die gelesen werden.</translation>
    </message>
    <message>
        <source>Choose another name: what is read is never replaced.</source>
        <translation>Wählen Sie einen anderen Namen: was gelesen wird, wird nie ersetzt.</translation>
    </message>
    <message>
        <source>The file exists already.</source>
        <translation>Die Datei gibt es schon.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Tracing until the noise is gone</source>
        <translation>Verfolgt, bis das Rauschen weg ist</translation>
    </message>
    <message>
        <source>The picture is noisier than was asked for.</source>
        <translation>Das Bild rauscht mehr als verlangt.</translation>
    </message>
    <message>
        <source>The picture must be a .png or .exr file.</source>
        <translation>Das Bild muss eine .png- oder .exr-Datei sein.</translation>
    </message>
    <message>
        <source>The picture cannot have that size.</source>
        <translation>Das Bild kann diese Größe nicht haben.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>Für dieses Bild ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Choose a smaller size, or close other programs.</source>
        <translation>Wählen Sie eine kleinere Größe, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>%1 samples were not finite and were dropped; please report this.</source>
        <translation>%1 Abtastungen waren nicht endlich und wurden weggelassen; bitte melden Sie das.</translation>
    </message>
    <message>
        <source>%1 light paths were too long for the device and were dropped.</source>
        <translation>%1 Lichtpfade waren zu lang für das Gerät und wurden weggelassen.</translation>
    </message>
    <message>
        <source>There is not enough memory to keep this study&apos;s model.</source>
        <translation>Es ist nicht genug Speicher da, um das Modell dieser Studie zu behalten.</translation>
    </message>
    <message>
        <source>The file of stored sessions was damaged. It was set aside, and what could be read of it was rescued.</source>
        <translation>Die Datei der gespeicherten Sitzungen war beschädigt. Sie wurde beiseitegelegt, und was davon lesbar war, wurde gerettet.</translation>
    </message>
    <message>
        <source>`macula sessions verify` says what is there.</source>
        <translation>`macula sessions verify` sagt, was da ist.</translation>
    </message>
    <message>
        <source>`macula sessions verify` says what else is.</source>
        <translation>`macula sessions verify` sagt, was es noch ist.</translation>
    </message>
    <message>
        <source>A stored model is damaged, and is not used.</source>
        <translation>Ein gespeichertes Modell ist beschädigt und wird nicht verwendet.</translation>
    </message>
    <message>
        <source>How this study was left was not found in time.</source>
        <translation>Wie diese Studie verlassen wurde, wurde nicht rechtzeitig gefunden.</translation>
    </message>
    <message>
        <source>It is kept until something is changed: open the study again to see it.</source>
        <translation>Es bleibt aufbewahrt, bis etwas geändert wird: öffnen Sie die Studie noch einmal, um es zu sehen.</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Of the series</source>
        <translation>Der Serie</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>The view was saved of another series.</source>
        <translation>Die Ansicht wurde von einer anderen Serie gespeichert.</translation>
    </message>
    <message>
        <source>Open that series, or choose another view.</source>
        <translation>Öffnen Sie diese Serie, oder wählen Sie eine andere Ansicht.</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open the study that the view is of first.</source>
        <translation>Öffnen Sie zuerst die Studie der Ansicht.</translation>
    </message>
    <message>
        <source>Choose a folder with a CT or MR series of several parallel slices.</source>
        <translation>Wählen Sie einen Ordner mit einer CT- oder MR-Serie aus mehreren parallelen Schichten.</translation>
    </message>
    <message>
        <source>Modality unknown</source>
        <translation>Modalität unbekannt</translation>
    </message>
    <message>
        <source>series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>series %1: %2</source>
        <translation>Serie %1: %2</translation>
    </message>
    <message>
        <source>series without a number</source>
        <translation>Serie ohne Nummer</translation>
    </message>
    <message>
        <source>series without a number: %1</source>
        <translation>Serie ohne Nummer: %1</translation>
    </message>
    <message>
        <source>no description</source>
        <translation>keine Beschreibung</translation>
    </message>
    <message>
        <source>phase %1 of %2</source>
        <translation>Phase %1 von %2</translation>
    </message>
    <message>
        <source>no study date</source>
        <translation>kein Studiendatum</translation>
    </message>
    <message>
        <source>The images of the file that was opened.</source>
        <translation>Die Bilder der geöffneten Datei.</translation>
    </message>
    <message>
        <source>The images are no volume.</source>
        <translation>Die Bilder sind kein Volumen.</translation>
    </message>
    <message>
        <source>%1: this is no image.</source>
        <translation>%1: das ist kein Bild.</translation>
    </message>
    <message>
        <source>No patient name</source>
        <translation>Kein Patientenname</translation>
    </message>
    <message>
        <source>No patient ID</source>
        <translation>Keine Patienten-ID</translation>
    </message>
    <message>
        <source>no patient ID</source>
        <translation>keine Patienten-ID</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geboren %1</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Das Phantom wird erstellt</translation>
    </message>
    <message>
        <source>Built-in phantom</source>
        <translation>Eingebautes Phantom</translation>
    </message>
    <message>
        <source>The volume that was chosen.</source>
        <translation>Das gewählte Volumen.</translation>
    </message>
    <message>
        <source>%1 file was left out; `macula info` on the folder says why.</source>
        <translation>%1 Datei wurde weggelassen; `macula info` zum Ordner sagt, warum.</translation>
    </message>
    <message>
        <source>%1 files were left out; `macula info` on the folder says why.</source>
        <translation>%1 Dateien wurden weggelassen; `macula info` zum Ordner sagt, warum.</translation>
    </message>
    <message>
        <source>There is not enough memory for this study.</source>
        <translation>Für diese Studie ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The study could not be opened.</source>
        <translation>Die Studie konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Run `macula info` on the folder to find out what is wrong with it.</source>
        <translation>Rufen Sie `macula info` zum Ordner auf, um zu erfahren, was daran falsch ist.</translation>
    </message>
    <message>
        <source>Nothing of the series can be seen.</source>
        <translation>Von der Serie ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose another preset or clip.</source>
        <translation>Wählen Sie eine andere Voreinstellung oder einen anderen Beschnitt.</translation>
    </message>
    <message>
        <source>The only volume.</source>
        <translation>Das einzige Volumen.</translation>
    </message>
    <message>
        <source>No folder was given: this is the built-in phantom.</source>
        <translation>Kein Ordner wurde angegeben: das ist das eingebaute Phantom.</translation>
    </message>
    <message>
        <source>%1 files were left out; macula info says why.</source>
        <translation>%1 Dateien wurden weggelassen; macula info sagt, warum.</translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Series %1: %2</source>
        <translation>Serie %1: %2</translation>
    </message>
    <message>
        <source>Series without a number</source>
        <translation>Serie ohne Nummer</translation>
    </message>
    <message>
        <source>Series without a number: %1</source>
        <translation>Serie ohne Nummer: %1</translation>
    </message>
    <message>
        <source>no images</source>
        <translation>keine Bilder</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>1 series</source>
        <translation>1 Serie</translation>
    </message>
    <message>
        <source>%1 series</source>
        <translation>%1 Serien</translation>
    </message>
    <message>
        <source>1 volume</source>
        <translation>1 Volumen</translation>
    </message>
    <message>
        <source>%1 volumes</source>
        <translation>%1 Volumen</translation>
    </message>
    <message>
        <source>1 object</source>
        <translation>1 Objekt</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 Objekte</translation>
    </message>
    <message>
        <source>Stack %1</source>
        <translation>Stapel %1</translation>
    </message>
    <message>
        <source>1 file left out</source>
        <translation>1 Datei weggelassen</translation>
    </message>
    <message>
        <source>%1 files left out</source>
        <translation>%1 Dateien weggelassen</translation>
    </message>
    <message>
        <source>The values were not counted.</source>
        <translation>Die Werte wurden nicht gezählt.</translation>
    </message>
    <message>
        <source>There is not enough memory to count the values.</source>
        <translation>Es ist nicht genug Speicher da, um die Werte zu zählen.</translation>
    </message>
    <message>
        <source>Close other programs, and open the study again.</source>
        <translation>Schließen Sie andere Programme, und öffnen Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>The file of settings is damaged.</source>
        <translation>Die Datei der Einstellungen ist beschädigt.</translation>
    </message>
    <message>
        <source>The usual settings are taken; what you set next is saved, and the damaged file is kept.</source>
        <translation>Es gelten die üblichen Einstellungen; was Sie als Nächstes einstellen, wird gespeichert, und die beschädigte Datei bleibt erhalten.</translation>
    </message>
    <message>
        <source>The settings could not be saved: their folder cannot be made.</source>
        <translation>Die Einstellungen konnten nicht gespeichert werden: ihr Ordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>The window cannot show Vulkan pictures.</source>
        <translation>Das Fenster kann keine Vulkan-Bilder zeigen.</translation>
    </message>
    <message>
        <source>Install a Vulkan driver for this display.</source>
        <translation>Installieren Sie einen Vulkan-Treiber für diese Anzeige.</translation>
    </message>
    <message>
        <source>This kind of display cannot show Vulkan pictures.</source>
        <translation>Diese Art von Anzeige kann keine Vulkan-Bilder zeigen.</translation>
    </message>
    <message>
        <source>Use an X11 or a Wayland display, or `macula render`.</source>
        <translation>Verwenden Sie eine X11- oder Wayland-Anzeige, oder `macula render`.</translation>
    </message>
</context>
<context>
    <name>pieces</name>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>low</source>
        <translation>gering</translation>
    </message>
    <message>
        <source>original axial</source>
        <translation>originale axiale</translation>
    </message>
    <message>
        <source>original</source>
        <translation>originale</translation>
    </message>
    <message>
        <source>axial</source>
        <translation>axiale</translation>
    </message>
    <message>
        <source>without interpolated slices and</source>
        <translation>ohne interpolierte Schichten und</translation>
    </message>
</context>
<context>
    <name>session</name>
    <message>
        <source>Stored sessions could not be opened.</source>
        <translation>Gespeicherte Sitzungen konnten nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the folder or a file in it is read-only.</source>
        <translation>Sitzungen können nicht gespeichert werden: der Ordner oder eine Datei darin ist schreibgeschützt.</translation>
    </message>
    <message>
        <source>Make the folder writable for you, or choose another one.</source>
        <translation>Machen Sie den Ordner für sich beschreibbar, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the disk is full.</source>
        <translation>Sitzungen können nicht gespeichert werden: der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>Free some space on that disk; what was stored before is unharmed.</source>
        <translation>Schaffen Sie Platz auf dem Datenträger; früher Gespeichertes ist unversehrt.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the drive cannot lock files.</source>
        <translation>Sitzungen können nicht gespeichert werden: das Laufwerk kann keine Dateien sperren.</translation>
    </message>
    <message>
        <source>Choose a folder on a local disk, or have locks switched on for that network drive.</source>
        <translation>Wählen Sie einen Ordner auf einem lokalen Datenträger, oder lassen Sie Sperren für das Netzlaufwerk einschalten.</translation>
    </message>
    <message>
        <source>Stored sessions are in use by another program.</source>
        <translation>Gespeicherte Sitzungen werden von einem anderen Programm benutzt.</translation>
    </message>
    <message>
        <source>Wait a moment and try again, or close other windows of Macula.</source>
        <translation>Warten Sie kurz und versuchen Sie es noch einmal, oder schließen Sie andere Fenster von Macula.</translation>
    </message>
    <message>
        <source>The file of stored sessions is damaged.</source>
        <translation>Die Datei der gespeicherten Sitzungen ist beschädigt.</translation>
    </message>
    <message>
        <source>Close all windows of Macula and start it again: it rescues what can be read, and keeps the file.</source>
        <translation>Schließen Sie alle Fenster von Macula und starten Sie es neu: es rettet, was lesbar ist, und behält die Datei.</translation>
    </message>
    <message>
        <source>Stored sessions were written by a newer version of Macula.</source>
        <translation>Gespeicherte Sitzungen stammen von einer neueren Version von Macula.</translation>
    </message>
    <message>
        <source>Use that version, or choose another folder. Nothing was changed.</source>
        <translation>Verwenden Sie diese Version, oder wählen Sie einen anderen Ordner. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The folder for sessions holds files of another program.</source>
        <translation>Der Ordner für Sitzungen enthält Dateien eines anderen Programms.</translation>
    </message>
    <message>
        <source>Choose an empty folder, or one that Macula made. Nothing was changed.</source>
        <translation>Wählen Sie einen leeren Ordner oder einen von Macula. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The disk reported an error while sessions were read or stored.</source>
        <translation>Der Datenträger meldete beim Lesen oder Speichern von Sitzungen einen Fehler.</translation>
    </message>
    <message>
        <source>Have the disk checked, or choose a folder on another one.</source>
        <translation>Lassen Sie den Datenträger prüfen, oder wählen Sie einen Ordner auf einem anderen.</translation>
    </message>
    <message>
        <source>There is not enough memory to read or store sessions.</source>
        <translation>Es ist nicht genug Speicher da, um Sitzungen zu lesen oder zu speichern.</translation>
    </message>
    <message>
        <source>Close other programs and try again.</source>
        <translation>Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>A stored model is damaged; it was set aside.</source>
        <translation>Ein gespeichertes Modell ist beschädigt; es wurde beiseitegelegt.</translation>
    </message>
    <message>
        <source>Nothing has to be done: the model is learnt anew.</source>
        <translation>Es ist nichts zu tun: das Modell wird neu gelernt.</translation>
    </message>
    <message>
        <source>A model is larger than all that may be stored.</source>
        <translation>Ein Modell ist größer als alles, was gespeichert werden darf.</translation>
    </message>
    <message>
        <source>Raise the limit for stored models.</source>
        <translation>Erhöhen Sie die Grenze für gespeicherte Modelle.</translation>
    </message>
    <message>
        <source>The stored model is no longer there.</source>
        <translation>Das gespeicherte Modell ist nicht mehr da.</translation>
    </message>
    <message>
        <source>A stored setting is damaged; it was set aside.</source>
        <translation>Eine gespeicherte Einstellung ist beschädigt; sie wurde beiseitegelegt.</translation>
    </message>
    <message>
        <source>Make the setting once more.</source>
        <translation>Machen Sie die Einstellung noch einmal.</translation>
    </message>
</context>
<context>
    <name>pipeline</name>
    <message>
        <source>There is no Vulkan driver on this computer, so nothing can be rendered.</source>
        <translation>Auf diesem Rechner ist kein Vulkan-Treiber, also kann nichts gezeichnet werden.</translation>
    </message>
    <message>
        <source>Install the driver of the graphics card, or, to render on the CPU, the Debian/Ubuntu package mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers</source>
        <translation>Installieren Sie den Treiber der Grafikkarte oder, um auf dem Prozessor zu zeichnen, das Debian-/Ubuntu-Paket mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers</translation>
    </message>
    <message>
        <source>The Vulkan driver of this computer does not offer %1.</source>
        <translation>Der Vulkan-Treiber dieses Rechners bietet %1 nicht.</translation>
    </message>
    <message>
        <source>Update the graphics driver.</source>
        <translation>Aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message>
        <source>The device %1 cannot be used: %2.</source>
        <translation>Das Gerät %1 kann nicht verwendet werden: %2.</translation>
    </message>
    <message>
        <source>Update its driver, or choose another device.</source>
        <translation>Aktualisieren Sie seinen Treiber, oder wählen Sie ein anderes Gerät.</translation>
    </message>
    <message>
        <source>The graphics device stopped responding %1 times within a minute.</source>
        <translation>Das Grafikgerät hat innerhalb einer Minute %1-mal nicht mehr geantwortet.</translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device: `macula devices` lists them, --device or MACULA_DEVICE takes one. The processor (llvmpipe) is slow but always there.</source>
        <translation>Aktualisieren Sie den Grafiktreiber, oder wählen Sie ein anderes Gerät: `macula devices` zählt sie auf, --device oder MACULA_DEVICE nimmt eines. Der Prozessor (llvmpipe) ist langsam, aber immer da.</translation>
    </message>
    <message>
        <source>The %1 does not fit on the device %2: it needs %3, and the device allows %4.</source>
        <translation>%1 passt nicht auf das Gerät %2: nötig sind %3, und das Gerät erlaubt %4.</translation>
    </message>
    <message>
        <source>Open a smaller series, or choose a device with more memory by MACULA_DEVICE.</source>
        <translation>Öffnen Sie eine kleinere Serie, oder wählen Sie mit MACULA_DEVICE ein Gerät mit mehr Speicher.</translation>
    </message>
    <message>
        <source>The device %1 cannot draw in this window.</source>
        <translation>Das Gerät %1 kann nicht in diesem Fenster zeichnen.</translation>
    </message>
    <message>
        <source>Choose the device that drives the display by MACULA_DEVICE.</source>
        <translation>Wählen Sie mit MACULA_DEVICE das Gerät, das die Anzeige treibt.</translation>
    </message>
    <message>
        <source>Could not %1: the computer&apos;s memory is full.</source>
        <translation>Fehler (%1): der Speicher des Rechners ist voll.</translation>
    </message>
    <message>
        <source>Could not %1: the graphics memory is full.</source>
        <translation>Fehler (%1): der Grafikspeicher ist voll.</translation>
    </message>
    <message>
        <source>Close other programs that draw in 3D, open a smaller series, or choose another device with MACULA_DEVICE.</source>
        <translation>Schließen Sie andere Programme, die in 3D zeichnen, öffnen Sie eine kleinere Serie, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Could not %1: the graphics device stopped responding and was reset.</source>
        <translation>Fehler (%1): das Grafikgerät hat nicht mehr geantwortet und wurde zurückgesetzt.</translation>
    </message>
    <message>
        <source>Try again. If this comes back, update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Versuchen Sie es noch einmal. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Could not %1: the window system took the window away.</source>
        <translation>Fehler (%1): das Fenstersystem hat das Fenster weggenommen.</translation>
    </message>
    <message>
        <source>Open the window again.</source>
        <translation>Öffnen Sie das Fenster noch einmal.</translation>
    </message>
    <message>
        <source>Could not %1: the graphics driver reports %2.</source>
        <translation>Fehler (%1): der Grafiktreiber meldet %2.</translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Aktualisieren Sie den Grafiktreiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>There is no room on the device for the peripheral model to learn.</source>
        <translation>Auf dem Gerät ist kein Platz, auf dem das periphere Modell lernen kann.</translation>
    </message>
    <message>
        <source>The stored peripheral model cannot be gone on with.</source>
        <translation>Mit dem gespeicherten peripheren Modell kann nicht weitergemacht werden.</translation>
    </message>
    <message>
        <source>Finding points</source>
        <translation>Punkte werden gesucht</translation>
    </message>
    <message>
        <source>Finding outlines</source>
        <translation>Umrisse werden gesucht</translation>
    </message>
    <message>
        <source>Tracing views</source>
        <translation>Ansichten werden verfolgt</translation>
    </message>
    <message>
        <source>Lighting views</source>
        <translation>Ansichten werden beleuchtet</translation>
    </message>
    <message>
        <source>What is visible takes %1 MiB and only %2 MiB can be had: %3 of %4 visible blocks (%5 %) are shown %6 voxels as one along each edge.</source>
        <translation>Das Sichtbare braucht %1 MiB, und nur %2 MiB sind zu haben: %3 von %4 sichtbaren Blöcken (%5 %) werden mit je %6 Voxeln als einem entlang jeder Kante gezeigt.</translation>
    </message>
    <message>
        <source>What is visible takes %1 MiB and only %2 MiB can be had: %3 of %4 visible blocks (%5 %) are shown %6 voxels as one along each edge or less.</source>
        <translation>Das Sichtbare braucht %1 MiB, und nur %2 MiB sind zu haben: %3 von %4 sichtbaren Blöcken (%5 %) werden mit je %6 Voxeln als einem entlang jeder Kante oder weniger gezeigt.</translation>
    </message>
    <message>
        <source>Show less of the volume by another preset or a clip, or use a device with more memory.</source>
        <translation>Zeigen Sie mit einer anderen Voreinstellung oder einem Beschnitt weniger vom Volumen, oder verwenden Sie ein Gerät mit mehr Speicher.</translation>
    </message>
    <message>
        <source>There is nothing to trace yet.</source>
        <translation>Es gibt noch nichts zu verfolgen.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>A volume of %1 million voxels is more than can be traced.</source>
        <translation>Ein Volumen von %1 Millionen Voxeln ist mehr, als verfolgt werden kann.</translation>
    </message>
    <message>
        <source>Open a smaller series.</source>
        <translation>Öffnen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>The preset was stretched to this volume: its %1 to %2 are drawn at %3 to %4, %5.</source>
        <translation>Die Voreinstellung wurde auf dieses Volumen gestreckt: ihre %1 bis %2 liegen bei %3 bis %4, %5.</translation>
    </message>
    <message>
        <source>the 2nd and 98th percentile of the foreground</source>
        <translation>dem 2. und 98. Perzentil des Vordergrunds</translation>
    </message>
    <message>
        <source>the smallest and largest value</source>
        <translation>dem kleinsten und größten Wert</translation>
    </message>
    <message>
        <source>Compare brightness and colours only within this volume.</source>
        <translation>Vergleichen Sie Helligkeit und Farben nur innerhalb dieses Volumens.</translation>
    </message>
    <message>
        <source>The file is no valid JSON.</source>
        <translation>Die Datei ist kein gültiges JSON.</translation>
    </message>
    <message>
        <source>The file is no valid JSON from %1 on.</source>
        <translation>Die Datei ist ab %1 kein gültiges JSON.</translation>
    </message>
    <message>
        <source>Look for a missing comma, quote or bracket there or just before.</source>
        <translation>Suchen Sie dort oder kurz davor nach einem fehlenden Komma, Anführungszeichen oder einer Klammer.</translation>
    </message>
    <message>
        <source>The key %1 is missing.</source>
        <translation>Der Schlüssel %1 fehlt.</translation>
    </message>
    <message>
        <source>The key %1 is unknown.</source>
        <translation>Der Schlüssel %1 ist unbekannt.</translation>
    </message>
    <message>
        <source>%1 is not as expected.</source>
        <translation>%1 ist nicht wie erwartet.</translation>
    </message>
    <message>
        <source>Expected %1.</source>
        <translation>Erwartet: %1.</translation>
    </message>
    <message>
        <source>Add it.</source>
        <translation>Fügen Sie ihn hinzu.</translation>
    </message>
    <message>
        <source>Known here: %1.</source>
        <translation>Hier bekannt: %1.</translation>
    </message>
</context>
</TS>
