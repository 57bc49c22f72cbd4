# Fields of forms.

page-form-none = none
page-form-wants-number = Enter a number from { $least } to { $most }.
page-form-wants-whole = Enter a whole number from { $least } to { $most }.
page-form-wants-text = Enter some text.
page-form-mix = Custom colour
page-form-remove = Delete: { $title }
